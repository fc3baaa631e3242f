#pragma once

#include <iosfwd>
#include <string>

namespace caustic {

/// What a profile's file holds, as JSON: for each path its subpaths with the control points of their segments, the
/// continuity at each joint, length with error bound, and exact bounding box. A line for each segment and joint.
///
/// Coordinates are the file's own: of an SVG file the user units of the outermost svg element, y pointing down.
/// @param name  as loadProfile takes it; without a choice every path that is drawn is shown
/// @throws InputError as loadProfile, before anything is written
void inspectProfile(const std::string& name, std::ostream& out);

}  // namespace caustic
