#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace caustic {

/// A number in a range, both ends included.
template <typename Number>
struct RangedValue {
    Number* value;  ///< where it goes
    Number least;
    Number most;
};

/// One of several words.
struct ChoiceValue {
    std::string* value;  ///< where it goes
    std::vector<std::string> choices;
};

/// Any text, as the name of a file is.
struct TextValue {
    std::string* value;  ///< where it goes
};

/// What an option takes.
using OptionValue = std::variant<RangedValue<double>, RangedValue<std::int64_t>, ChoiceValue, TextValue>;

/// An option of a chapter's own. Its value goes into a variable that has to live as long as the command line is read;
/// what that holds before is the default.
struct ChapterOption {
    std::string name;  ///< "--minutes"
    std::string type;  ///< what the value is called in --help: "MINUTES"
    std::string help;  ///< what it says, in a few words
    OptionValue value;
};

}  // namespace caustic
