#pragma once

#include <functional>
#include <string>
#include <vector>

#include "figure/figure.h"

namespace caustic {

/// Something else that a chapter's executable does, with one argument: "--inspect FILE".
struct ChapterCommand {
    std::string option;    ///< "--inspect"
    std::string argument;  ///< what the argument is called in --help: "FILE"
    std::string help;      ///< what it does, in a few words

    /// Does it; throws InputError for bad input, as figures do.
    std::function<void(const std::string& argument, const ChapterOptions& options)> run;
};

/// The main function of every chapter: reads the command line, draws the figures of the table (all, or those of
/// --only), records where each came from and what it cost.
///
/// A command of `commands`, when the user gives one, runs instead of the figures.
/// @return the exit code: 0, 1 for a failure of ours, 2 for bad input (said in one line on standard error)
int runChapter(const ChapterInputs& inputs, int argc, const char* const* argv, const std::vector<Figure>& figures,
               const std::vector<ChapterCommand>& commands = {});

}  // namespace caustic
