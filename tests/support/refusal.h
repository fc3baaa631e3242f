#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <string>

#include "core/error.h"

namespace caustic::test {

/// Whether the call refuses that value, by name: InputError's place says what is wrong and its value how it is now.
inline ::testing::AssertionResult refuses(const std::function<void()>& call, const std::string& what,
                                          const std::string& value) {
    try {
        call();
    } catch (const InputError& error) {
        if (error.place().file == what && error.value() == value) return ::testing::AssertionSuccess();
        return ::testing::AssertionFailure()
               << "It says \"" << error.what() << "\": which name, and which value, go where in checkArgument()?";
    }
    return ::testing::AssertionFailure() << what << " " << value << " is not refused.";
}

}  // namespace caustic::test
