#pragma once

#include <filesystem>
#include <vector>

namespace caustic {

/// Runs gnuplot on the scripts, one after the other in one process. They find two variables: `folder`, where the CSV
/// files are, and `output`, the PNG to write (through a temporary file and a rename).
/// @throws InputError when gnuplot is missing or complains; its own message is the reason
void drawChart(const std::vector<std::filesystem::path>& scripts, const std::filesystem::path& folder,
               const std::filesystem::path& png);

}  // namespace caustic
