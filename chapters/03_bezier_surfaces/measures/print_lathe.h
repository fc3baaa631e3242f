#pragma once

#include <iosfwd>

namespace caustic {

/// Intersects a square picture's rays with the plain vase and prints as JSON: the profile's control points, eye and
/// axes of the picture, nanoseconds a ray and a test (a ray that its box doesn't stop), and the heights that were hit,
/// row by row (null for none). What `./course bench lathe` holds beside POV-Ray.
/// @param width  of the picture, pixels
void printLathe(int width, std::ostream& out);

}  // namespace caustic
