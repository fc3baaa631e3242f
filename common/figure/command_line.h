#pragma once

#include <optional>
#include <string>
#include <vector>

#include "figure/chapter.h"

namespace caustic {

/// What the user wants of a chapter's executable.
struct CommandLine {
    ChapterOptions options;
    std::vector<std::string> only;            ///< figures; all of them when empty
    bool list = false;                        ///< whether to list the figures and leave
    const ChapterCommand* command = nullptr;  ///< what to do instead of figures
};

/// Reads a command line. Values of the commands' options go where these say.
/// @return nothing when the user asked for help, which is printed then
/// @throws InputError for an unknown option, a value that isn't one, or an option that would do nothing in this call
std::optional<CommandLine> readCommandLine(const std::string& chapter, const std::vector<ChapterCommand>& commands,
                                           int argc, const char* const* argv);

}  // namespace caustic
