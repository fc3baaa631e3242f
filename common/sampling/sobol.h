#pragma once

#include <cstdint>

namespace caustic {

/// Dimensions that sobolBits knows.
inline constexpr int sobolDimensions = 6;

/// One coordinate of a point of Sobol's sequence, as 32 bits behind the binary point: bits · 2⁻³² is in [0, 1).
///
/// Among the first 2ᵐ points, and among each further run of 2ᵐ that starts at a multiple of 2ᵐ, each of the 2ᵐ equal
/// intervals holds one; of dimensions 0 and 1 together, every box of that area whose sides are powers of two does.
/// Source: Sobol' 1967; direction numbers: Joe, Kuo 2008, Constructing Sobol Sequences with Better Two-Dimensional
/// Projections, SIAM J. Sci. Comput. 30(5).
/// @param index      of the point, from 0
/// @param dimension  0 ... sobolDimensions − 1
std::uint32_t sobolBits(std::uint32_t index, int dimension);

/// Owen's nested uniform scrambling: whether a bit is flipped is decided at random, by the seed and by all bits above
/// it. So numbers that share their first k bits share them afterwards, too: as evenly spread as they were, each is now
/// uniform in [0, 1). Source: Owen 1995, Randomly Permuted (t,m,s)-Nets; by a hash of the reversed bits: Laine, Karras
/// 2011, Stratified Sampling for Stochastic Transparency; constants: Burley 2020, Practical Hash-based Owen Scrambling,
/// JCGT 9(4).
/// @param bits  behind the binary point
/// @param seed  names the scrambling; different seeds give independent ones
std::uint32_t owenScrambled(std::uint32_t bits, std::uint32_t seed);

}  // namespace caustic
