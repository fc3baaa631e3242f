#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "curve/bezier_spline.h"
#include "curve/svg_transform.h"

namespace caustic {

/// A `path` element of an SVG file, not yet turned into curves.
struct SvgPathElement {
    std::string id;           ///< may be empty
    std::size_t line = 0;     ///< where the element begins
    bool drawn = true;        ///< false inside defs, clipPath, mask, symbol and the like
    std::string data;         ///< the `d` attribute; empty draws nothing
    InputPlace dataPlace;     ///< where its value begins
    SvgTransform transform;   ///< from the path's units to those of the outermost svg element: all that groups set
    std::string displacedBy;  ///< what else moves it and is not followed (see parseSvg); mostly empty
};

/// What this reader sees in an SVG file.
struct SvgDocument {
    std::string file;                          ///< what errors call it
    std::vector<SvgPathElement> paths;         ///< in the order of the file
    std::map<std::string, int> otherDrawings;  ///< how many rect, circle, use, text... are drawn beside them
    Real bottom = 0;  ///< y of the page's lower edge, from the viewBox or else the height; 0 when neither says
};

/// Finds the paths of an SVG file. No curve is built yet: that is svgSplines, so that one bad path doesn't hide
/// another.
///
/// Transforms of all elements around a path add up. Content of nested svg, g, a and switch is drawn (of a switch all of
/// it); content of any other element, and elements of other namespaces, are not. Not followed: `use`, style sheets, and
/// what SVG offers beyond the `transform` attribute to displace something (a transform in `style`, a nested svg with a
/// viewBox or with units); a path displaced so is refused by svgSplines.
/// @param text  the whole file, in UTF-8
/// @param file  what errors call it
/// @throws InputError with the line: no XML, no SVG, a bad transform, entity declarations (which could make a small
/// file
///         grow without bound), or so much markup that it would take over 100 MB to hold
SvgDocument parseSvg(std::string_view text, const std::string& file);

/// The curves of a path, a spline for each subpath, in the units of the outermost svg element, y pointing down as
/// there.
/// @throws InputError as parseSvgPathData, or when something unknown displaces the path
std::vector<BezierSpline> svgSplines(const SvgPathElement& path);

/// The path that the user means.
/// @param choice  an id, or the path's number among those drawn, from 1; empty when there is only one to choose
/// @throws InputError when there is no such path, or several and no choice: lists the ids
const SvgPathElement& chosenPath(const SvgDocument& document, const std::string& choice);

}  // namespace caustic
