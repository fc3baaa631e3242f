#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace caustic {

/// Text as a gnuplot string, in quotes.
std::string gnuplotString(const std::string& text);

/// Runs gnuplot on the scripts, one after the other in one process. They find two variables: `folder`, where the CSV
/// files are, and `output`, the PNG to write (through a temporary file and a rename).
/// @param settings  gnuplot commands that come before the scripts
/// @throws InputError when gnuplot is missing or complains; its own message is the reason
void drawChart(const std::vector<std::filesystem::path>& scripts, const std::filesystem::path& folder,
               const std::filesystem::path& png, const std::string& settings = "");

}  // namespace caustic
