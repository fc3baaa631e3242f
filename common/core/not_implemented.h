#pragma once

#include <stdexcept>
#include <string>

namespace caustic {

/// Thrown by the starter's stubs: the body of this exercise is still to be written.
class NotImplemented : public std::logic_error {
public:
    /// @param exercise  its marker, as in "ex-01.1"
    explicit NotImplemented(const std::string& exercise)
        : std::logic_error("exercise " + exercise + " is not implemented yet") {}
};

}  // namespace caustic
