#pragma once

#include <cstdint>
#include <iosfwd>
#include <string>

namespace caustic {

/// Counts the leaks of each triangle test (countLeaks) and prints them as JSON: a list of objects with method, aim,
/// leaks and rays. What `./course bench leaks` adds up.
/// @param rays  how many for each test and aim, as text
/// @throws InputError unless it is a whole number from 1 to 10^9, before anything is written
void printLeaks(const std::string& rays, std::uint64_t seed, int threads, std::ostream& out);

}  // namespace caustic
