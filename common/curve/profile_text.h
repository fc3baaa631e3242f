#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "curve/bezier_spline.h"

namespace caustic {

/// Reads a profile from text, as the report's author typed it in:
///
///     # 3n + 1 control points; a line each: x y, or x y z
///     0   0
///     3.5 0    # what follows # is a comment
///     ...
///     closed   # perhaps, as the last line: the spline leads back to its beginning
///
/// @param file  what errors call it
/// @throws InputError with the line for anything else, for NaN, infinities and coordinates beyond largestCoordinate
BezierSpline parseProfileText(std::string_view text, const std::string& file);

/// The same spline as text: two columns when every z is zero. Reads back exactly, to the last bit.
/// @throws InputError when a segment doesn't begin exactly where the one before it ends
std::string profileText(const BezierSpline& spline);

/// Writes profileText(spline) through a temporary file and a rename.
void saveProfileText(const BezierSpline& spline, const std::filesystem::path& path);

}  // namespace caustic
