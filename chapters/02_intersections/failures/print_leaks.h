#pragma once

#include <cstdint>
#include <iosfwd>

namespace caustic {

/// Counts the leaks of each triangle test (countLeaks) and prints them as JSON: a list of objects with method, aim,
/// leaks and rays. What `./course bench leaks` adds up.
/// @param rays  how many for each test and aim
void printLeaks(std::int64_t rays, std::uint64_t seed, int threads, std::ostream& out);

}  // namespace caustic
