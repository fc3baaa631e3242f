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
    bool drawn = true;        ///< false inside defs, clipPath, mask, symbol and the like, and where display or
                              ///< visibility hide it
    std::string data;         ///< the `d` attribute; empty draws nothing
    InputPlace dataPlace;     ///< where its value begins
    SvgTransform transform;   ///< from the path's units to those of the outermost svg element: all that groups set
    std::string notFollowed;  ///< what else hides, moves or bends it (see parseSvg); mostly empty
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
/// Transforms of all elements around a path add up: the attribute, or `transform` in a style, which goes before it;
/// about `transform-origin` when that is given in lengths. Content of nested svg, g and a is drawn, and of a switch its
/// first child that needs no extension, as long as `display` and `visibility`, in attributes or styles, hide none of
/// it; content of any other element, and elements of other namespaces, are not.
///
/// Not followed, so that svgSplines refuses the path and says why: style sheets and animations that hide or displace,
/// CSS's translate, rotate, scale, offset, zoom and d, origins and transforms that depend on a box or a font,
/// transforms in space, a transform of the outermost svg, a nested svg with a viewBox or with units, and a switch by
/// language. `use` is not followed either.
/// @param text  the whole file, in UTF-8
/// @param file  what errors call it
/// @throws InputError with the line: no XML, no SVG, a bad transform, entity declarations (which could make a small
/// file
///         grow without bound), or so much markup that it would take over 100 MB to hold
SvgDocument parseSvg(std::string_view text, const std::string& file);

/// The curves of a path, a spline for each subpath, in the units of the outermost svg element, y pointing down as
/// there.
/// @throws InputError as parseSvgPathData, or when the path depends on what is not followed
std::vector<BezierSpline> svgSplines(const SvgPathElement& path);

/// The path that the user means.
/// @param choice  an id, or the path's number among those drawn, from 1; empty when there is only one to choose
/// @throws InputError when there is no such path, or several and no choice: lists the ids
const SvgPathElement& chosenPath(const SvgDocument& document, const std::string& choice);

}  // namespace caustic
