#pragma once

#include <cstdint>
#include <limits>

#include "math/real.h"

#ifdef __AVX2__
#include <immintrin.h>
#endif

namespace caustic {

#ifdef __AVX512F__
/// How many numbers of type Real one instruction works on: four, eight where there is AVX-512.
inline constexpr unsigned wideRealLanes = 8;
/// Names all of them; GCC 12 warns of its own header where an instruction is used without such a mask.
inline constexpr unsigned char allLanes = 0xff;
#else
inline constexpr unsigned wideRealLanes = 4;
#endif

/// So many numbers of type Real. As with Float8, `+ - * / <` act lane by lane; each lane rounds as a Real does.
using WideReal = Real __attribute__((vector_size(wideRealLanes * sizeof(Real))));
/// As many floats: to be kept, and widened before anything is computed.
using WideFloat = float __attribute__((vector_size(wideRealLanes * sizeof(float))));
/// What a comparison of WideReal gives: -1 in the lanes where it holds, 0 in the others.
using WideMask = std::int64_t __attribute__((vector_size(wideRealLanes * sizeof(Real))));

/// The same value in all lanes. (WideReal{} + value would be an addition.)
inline WideReal inAllLanes(Real value) {
#if defined(__AVX512F__)
    return _mm512_set1_pd(value);
#elif defined(__AVX2__)
    return _mm256_set1_pd(value);
#else
    return WideReal{} + value;
#endif
}

/// The same numbers as Real: exact. The compiler's own conversion takes three instructions for each of these.
inline WideReal widened(WideFloat values) {
#if defined(__AVX512F__)
    return _mm512_maskz_cvtps_pd(allLanes, values);
#elif defined(__AVX2__)
    return _mm256_cvtps_pd(values);
#else
    return __builtin_convertvector(values, WideReal);
#endif
}
/// Nothing to be done.
inline WideReal widened(WideReal values) { return values; }

/// The smaller one, lane by lane; b where one is NaN.
inline WideReal smaller(WideReal a, WideReal b) {
#if defined(__AVX512F__)
    return _mm512_maskz_min_pd(allLanes, a, b);
#elif defined(__AVX2__)
    return _mm256_min_pd(a, b);
#else
    return a < b ? a : b;
#endif
}

/// The larger one, lane by lane; b where one is NaN.
inline WideReal larger(WideReal a, WideReal b) {
#if defined(__AVX512F__)
    return _mm512_maskz_max_pd(allLanes, a, b);
#elif defined(__AVX2__)
    return _mm256_max_pd(a, b);
#else
    return a > b ? a : b;
#endif
}

/// Without its sign, lane by lane.
inline WideReal magnitude(WideReal a) {
    constexpr std::int64_t allButSign = std::numeric_limits<std::int64_t>::max();
    return reinterpret_cast<WideReal>(reinterpret_cast<WideMask>(a) & allButSign);
}

/// A bit for each lane whose comparison held.
inline unsigned lanesOf(WideMask mask) {
#if defined(__AVX512DQ__)
    return _mm512_movepi64_mask(reinterpret_cast<__m512i>(mask));
#elif defined(__AVX2__) && !defined(__AVX512F__)
    return static_cast<unsigned>(_mm256_movemask_pd(reinterpret_cast<WideReal>(mask)));
#else
    unsigned bits = 0;
    for (unsigned lane = 0; lane < wideRealLanes; ++lane) bits |= mask[lane] != 0 ? 1U << lane : 0U;
    return bits;
#endif
}

}  // namespace caustic
