#pragma once

#include <string>

#include "curve/bezier_spline.h"

namespace caustic {

/// A profile's file as it was read, not yet parsed.
struct ProfileFile {
    std::string file;    ///< its path, as errors call it
    std::string choice;  ///< which of an SVG file's paths: what followed the # of "glass.svg#outline"; mostly empty
    std::string text;    ///< all of it
    bool svg = false;    ///< SVG, or else control points; its content says so, not its name
};

/// Reads the file that a profile's name names: a path, perhaps with "#id" or "#number". A # that belongs to the name of
/// an existing file chooses nothing.
/// @throws InputError when it can't be read, is larger than mostProfileBytes, or has nothing to choose from
ProfileFile readProfileFile(const std::string& name);

/// Reads a profile: a file of control points, or a path of an SVG file.
///
/// A profile has y upwards: an SVG page is turned over, so that its lower edge becomes y = 0 (when neither viewBox nor
/// height says where that is, y is only negated). x stays: for a surface of revolution the axis is x = 0, the page's
/// left edge.
/// @param name  as readProfileFile takes it
/// @throws InputError when it can't be read, the choice is missing or wrong, or the path is not one curve in one piece
BezierSpline loadProfile(const std::string& name);

}  // namespace caustic
