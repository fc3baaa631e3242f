#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace caustic::test {

/// How a program ended and what it took.
struct MeasuredRun {
    int exitCode = 0;    ///< 128 + signal when a signal ended it
    std::string output;  ///< what it wrote to standard output
    std::string errors;  ///< what it wrote to standard error
    double peakMiB = 0;  ///< most memory that it held at a time (resident set)
};

/// Runs a program in a folder, without a shell and without standard input, and waits for it. Ends it by a signal once
/// it has used `mostSeconds` of processor time.
MeasuredRun runMeasured(const std::vector<std::string>& command, const std::filesystem::path& folder,
                        unsigned mostSeconds = 60);

}  // namespace caustic::test
