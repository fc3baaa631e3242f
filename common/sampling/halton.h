#pragma once

#include <cstdint>

#include "math/real.h"

namespace caustic {

/// Dimensions that haltonNumber knows: the bases are the first so many primes, 2 to 29.
inline constexpr int haltonDimensions = 10;

/// One coordinate of a point of Halton's sequence, its digits permuted.
///
/// The index is written in the dimension's base, and its digits are read the other way round, behind the point: the
/// last one counts most. So each run of bᵐ points that starts at a multiple of bᵐ has one in each of bᵐ equal
/// intervals. Before that, each digit goes through a permutation that belongs to its place; leading zeros do, too,
/// without end. That leaves one point in each interval, makes the number uniform, and parts dimensions of large bases,
/// which otherwise climb side by side. Numbers are multiples of the largest b⁻ᵏ that is at most 2⁻³². Source: Halton
/// 1960, On the efficiency of certain quasi-random sequences of points, Numer. Math. 2, eq. 3 (radical inverse);
/// permuted digits: Matoušek 1998, On the L2-discrepancy for anchored boxes, J. Complexity 14.
/// @param index      of the point, from 0
/// @param dimension  0 ... haltonDimensions − 1
/// @param key        names the permutations; different keys give independent ones
/// @return in [0, 1)
Real haltonNumber(std::uint32_t index, int dimension, std::uint64_t key);

}  // namespace caustic
