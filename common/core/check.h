#pragma once

#include <cmath>
#include <string>
#include <string_view>

#include "core/error.h"
#include "core/text.h"

namespace caustic {

/// Throws InputError unless `holds`. `what` names the argument, `reason` says what it must be.
inline void checkArgument(bool holds, const std::string& what, const std::string& value, const std::string& reason) {
    if (!holds) throw InputError({what, 0}, value, reason);
}

// Below, what an error would say is put together only when there is one: curves check each of their coordinates.

/// Throws InputError unless `value` is a finite number.
inline void checkFinite(double value, std::string_view what) {
    if (!std::isfinite(value)) throw InputError({std::string(what), 0}, formatReal(value), "must be a finite number");
}

/// Throws InputError unless `value` is finite and greater than zero.
inline void checkPositive(double value, std::string_view what) {
    if (!std::isfinite(value) || value <= 0)
        throw InputError({std::string(what), 0}, formatReal(value), "must be greater than 0");
}

}  // namespace caustic
