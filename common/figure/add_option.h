#pragma once

#include <string>

#include <CLI/CLI.hpp>

#include "figure/chapter_option.h"

namespace caustic {

/// Adds an option to a command line. A value out of its domain is a CLI::ParseError.
CLI::Option* addOption(CLI::App& app, const ChapterOption& option);

/// What is wrong with a value that was given, in a sentence without a subject; empty when nothing is. CLI11's own
/// checks take "nan" for a number in any range.
std::string complaint(const OptionValue& value, const std::string& text);

/// What an option takes, as --help shows it behind the option's type: " in [1, 9]", " {pass, point}"; empty for any
/// text.
std::string domainText(const OptionValue& value);

}  // namespace caustic
