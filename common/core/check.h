#pragma once

#include <cmath>
#include <string>

#include "core/error.h"
#include "core/text.h"

namespace caustic {

/// Throws InputError unless `holds`. `what` names the argument, `reason` says what it must be.
inline void checkArgument(bool holds, const std::string& what, const std::string& value, const std::string& reason) {
    if (!holds) throw InputError({what, 0}, value, reason);
}

/// Throws InputError unless `value` is a finite number.
inline void checkFinite(double value, const std::string& what) {
    checkArgument(std::isfinite(value), what, formatReal(value), "must be a finite number");
}

/// Throws InputError unless `value` is finite and greater than zero.
inline void checkPositive(double value, const std::string& what) {
    checkArgument(std::isfinite(value) && value > 0, what, formatReal(value), "must be greater than 0");
}

}  // namespace caustic
