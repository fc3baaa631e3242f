#pragma once

#include <cstdint>
#include <iosfwd>
#include <string>

namespace caustic {

/// Examines the root finders (root_examination.h) with so many random rays, and a tenth as many of each adversarial
/// set, and prints what was counted as JSON: a list of objects, one a set. What `./course bench roots` adds up.
/// @param rays  random rays at each kind of surface, as text
/// @throws InputError unless it is a whole number from 10 to 10^9, before anything is written
void printRoots(const std::string& rays, std::uint64_t seed, int threads, std::ostream& out);

}  // namespace caustic
