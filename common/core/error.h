#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>

namespace caustic {

/// Where a wrong value stands: a file (or "command line", "argument"), and its line if it has one.
struct InputPlace {
    std::string file;      ///< path as the user gave it, or what stands for it
    std::size_t line = 0;  ///< counted from 1; 0 when a line makes no sense (a binary file, an argument)
};

/// Bad input of any kind: a file that cannot be read, a value out of its domain, an impossible option.
///
/// The only exception that the course throws on purpose; a chapter's executable prints it as one line and leaves with
/// exit code 2. what() reads as a compiler's message does: "vase.svg:12: must be finite (got 'nan')".
class InputError : public std::runtime_error {
public:
    /// @param place   where the value stands
    /// @param value   the offending text, shortened when it is long; may be empty
    /// @param reason  what is wrong and what would be right, in one sentence without a full stop
    InputError(InputPlace place, std::string value, std::string reason);

    /// Where the value stands.
    const InputPlace& place() const { return place_; }
    /// The offending text; may be empty.
    const std::string& value() const { return value_; }
    /// What is wrong and what would be right.
    const std::string& reason() const { return reason_; }

private:
    InputPlace place_;
    std::string value_;
    std::string reason_;
};

}  // namespace caustic
