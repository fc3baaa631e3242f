#pragma once

namespace caustic {

/// The course's floating-point type. Measured in chapter 02: in float a shadow ray's origin can't be told from its
/// surface at coordinates near 1000.
using Real = double;

}  // namespace caustic
