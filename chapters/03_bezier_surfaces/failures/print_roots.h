#pragma once

#include <cstdint>
#include <iosfwd>

namespace caustic {

/// Examines the root finders (root_examination.h) with so many random rays, and a tenth as many of each adversarial
/// set, and prints what was counted as JSON: a list of objects, one a set. What `./course bench roots` adds up.
/// @param rays  random rays at each kind of surface, at least 10
void printRoots(std::int64_t rays, std::uint64_t seed, int threads, std::ostream& out);

}  // namespace caustic
