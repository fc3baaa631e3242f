#pragma once

#include <pugixml.hpp>
#include <string_view>

#include "curve/svg_document.h"

namespace caustic {

/// Walks over the tree of an SVG file and lists its paths in the document, each with what the elements around it set:
/// transforms, visibility, what can't be followed. parseSvg says what that is.
/// @param text    the file
/// @param buffer  the same, as the XML parser left it: attributes were parsed in place
void findSvgPaths(std::string_view text, const char* buffer, const pugi::xml_document& xml, SvgDocument& document);

}  // namespace caustic
