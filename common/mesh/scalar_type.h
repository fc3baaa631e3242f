#pragma once

#include <bit>
#include <cstddef>

#include "math/real.h"

namespace caustic {

/// How a file stores a number.
enum class ScalarType { Int8, Uint8, Int16, Uint16, Int32, Uint32, Float32, Float64 };

/// Bytes of a number of that type.
std::size_t sizeOf(ScalarType type);

/// Whether it is a floating-point type.
bool isReal(ScalarType type);

/// The number that the bytes are; exact, for a double holds all that any of the types does.
/// @param bytes  sizeOf(type) of them, at any address
Real readScalar(const char* bytes, ScalarType type, std::endian order);

}  // namespace caustic
