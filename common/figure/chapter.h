#pragma once

#include <functional>
#include <string>
#include <vector>

#include "figure/chapter_option.h"
#include "figure/figure.h"

namespace caustic {

/// Something else that a chapter's executable does instead of figures: "--inspect FILE".
struct ChapterCommand {
    ChapterOption argument;  ///< the option that asks for it; its value has no default

    /// Does it; throws InputError for bad input, as figures do.
    std::function<void(const ChapterOptions& options)> run;

    std::vector<std::string> uses = {};       ///< those of --out, --quality, --threads and --seed that do something
    std::vector<ChapterOption> options = {};  ///< its own; two commands may have the same one, with the same variable
};

/// The main function of every chapter: reads the command line, draws the figures of the table (all, or those of
/// --only), records where each came from and what it cost.
///
/// A command of `commands`, when the user gives one, runs instead of the figures. An option that would do nothing in
/// this call is refused.
/// @return the exit code: 0, 1 for a failure of ours, 2 for bad input (said in one line on standard error)
int runChapter(const ChapterInputs& inputs, int argc, const char* const* argv, const std::vector<Figure>& figures,
               const std::vector<ChapterCommand>& commands = {});

}  // namespace caustic
