#pragma once

#include <cstdint>

namespace caustic {

/// Where position `i` of a list of `count` goes in a shuffle that is named by `key`: a permutation of 0 ... count-1
/// that needs no table. Any key gives one of them; different keys give different-looking ones. Source: Kensler 2013,
/// Correlated Multi-Jittered Sampling, Pixar TM 13-01, function permute.
/// @param i      less than count
/// @param count  greater than 0
std::uint32_t permuted(std::uint32_t i, std::uint32_t count, std::uint32_t key);

}  // namespace caustic
