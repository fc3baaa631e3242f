#include "mesh/scalar_type.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>

namespace caustic {

namespace {

template <typename T>
Real readAs(const char* bytes, std::endian order) {
    std::array<char, sizeof(T)> own;
    std::memcpy(own.data(), bytes, sizeof(T));
    if (order != std::endian::native) std::ranges::reverse(own);
    return static_cast<Real>(std::bit_cast<T>(own));
}

}  // namespace

std::size_t sizeOf(ScalarType type) {
    switch (type) {
        case ScalarType::Int8:
        case ScalarType::Uint8:
            return 1;
        case ScalarType::Int16:
        case ScalarType::Uint16:
            return 2;
        case ScalarType::Float64:
            return 8;
        default:
            return 4;
    }
}

bool isReal(ScalarType type) { return type == ScalarType::Float32 || type == ScalarType::Float64; }

Real readScalar(const char* bytes, ScalarType type, std::endian order) {
    switch (type) {
        case ScalarType::Int8:
            return readAs<std::int8_t>(bytes, order);
        case ScalarType::Uint8:
            return readAs<std::uint8_t>(bytes, order);
        case ScalarType::Int16:
            return readAs<std::int16_t>(bytes, order);
        case ScalarType::Uint16:
            return readAs<std::uint16_t>(bytes, order);
        case ScalarType::Int32:
            return readAs<std::int32_t>(bytes, order);
        case ScalarType::Uint32:
            return readAs<std::uint32_t>(bytes, order);
        case ScalarType::Float32:
            return readAs<float>(bytes, order);
        default:
            return readAs<double>(bytes, order);
    }
}

}  // namespace caustic
