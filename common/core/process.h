#pragma once

#include <optional>
#include <string>
#include <vector>

namespace caustic {

/// How a finished program ended.
struct ProcessResult {
    int exitCode = 0;    ///< 128 + signal when a signal ended it
    std::string output;  ///< what it wrote to standard output and standard error
};

/// Runs a program found on the PATH, without a shell and without standard input, and waits for it.
/// @return nothing when there is no such program
std::optional<ProcessResult> runProcess(const std::vector<std::string>& command);

}  // namespace caustic
