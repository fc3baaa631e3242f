#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#ifdef __AVX2__
#include <immintrin.h>
#endif

namespace caustic {

/// Eight floats that one instruction works on, written with the compilers' vector extension: `+ - * <` act lane by
/// lane, a comparison gives -1 in the lanes where it holds. Eigen's arrays have no masks, which is what trees live on.
using Float8 = float __attribute__((vector_size(32)));
/// Eight integers, and what a comparison of Float8 gives.
using Int8 = std::int32_t __attribute__((vector_size(32)));

/// The same value in all lanes.
inline Float8 broadcast8(float value) { return Float8{value, value, value, value, value, value, value, value}; }

/// The smaller one, lane by lane; b where one is NaN.
inline Float8 min8(Float8 a, Float8 b) {
#ifdef __AVX2__
    return _mm256_min_ps(a, b);
#else
    return a < b ? a : b;
#endif
}

/// The larger one, lane by lane; b where one is NaN.
inline Float8 max8(Float8 a, Float8 b) {
#ifdef __AVX2__
    return _mm256_max_ps(a, b);
#else
    return a > b ? a : b;
#endif
}

/// a · b + c, rounded once.
inline Float8 fma8(Float8 a, Float8 b, Float8 c) {
#ifdef __FMA__
    return _mm256_fmadd_ps(a, b, c);
#else
    for (int lane = 0; lane < 8; ++lane) c[lane] = std::fma(a[lane], b[lane], c[lane]);
    return c;
#endif
}

/// a · b - c, rounded once.
inline Float8 fms8(Float8 a, Float8 b, Float8 c) {
#ifdef __FMA__
    return _mm256_fmsub_ps(a, b, c);
#else
    return fma8(a, b, -c);
#endif
}

/// a with its sign turned where that of `sign` is negative.
inline Float8 turnSign8(Float8 a, Float8 sign) {
    constexpr std::int32_t signBit = std::numeric_limits<std::int32_t>::min();
    return std::bit_cast<Float8>(std::bit_cast<Int8>(a) ^ (std::bit_cast<Int8>(sign) & signBit));
}

/// A bit for each lane whose comparison held.
inline unsigned lanesOf(Int8 mask) {
#ifdef __AVX2__
    return static_cast<unsigned>(_mm256_movemask_ps(std::bit_cast<Float8>(mask)));
#else
    unsigned bits = 0;
    for (int lane = 0; lane < 8; ++lane) bits |= mask[lane] != 0 ? 1U << lane : 0U;
    return bits;
#endif
}

}  // namespace caustic
