#pragma once

#include <cstdint>

namespace caustic {

/// 2^64 / golden ratio, odd: multiples of it lie far apart, and added before mixing it keeps 0 from being a fixed
/// point. Source: Steele, Lea, Flood 2014, Fast Splittable Pseudorandom Number Generators, section 3.
inline constexpr std::uint64_t goldenStep = 0x9e3779b97f4a7c15ULL;

/// SplitMix64's finaliser: 64 bits, each of which depends on every bit of x. One to one.
/// Source: Steele, Lea, Flood 2014, fig. 17.
constexpr std::uint64_t splitMix(std::uint64_t x) {
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
    return x ^ (x >> 31);
}

}  // namespace caustic
