#include "curve/svg_document.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <pugixml.hpp>

#include "core/text.h"
#include "curve/profile_limits.h"
#include "curve/svg_path_data.h"
#include "curve/svg_path_finder.h"
#include "curve/svg_scanner.h"

namespace caustic {

namespace {

// pugixml keeps 64 bytes for an element or a text and 40 for an attribute.
constexpr std::size_t bytesPerTag = 2 * 64;
constexpr std::size_t bytesPerAttribute = 40;
constexpr std::size_t mostTreeBytes = std::size_t{100} << 20;

void checkMarkup(std::string_view text, const std::string& file) {
    const auto tags = static_cast<std::size_t>(std::count(text.begin(), text.end(), '<'));
    const auto attributes = static_cast<std::size_t>(std::count(text.begin(), text.end(), '='));
    if (tags * bytesPerTag + attributes * bytesPerAttribute <= mostTreeBytes) return;
    throw InputError({file, 0}, std::to_string(tags) + " tags", "has more markup than a drawing needs");
}

// From the viewBox, or else the height where it is a plain number or one in px, which is the same.
Real pageBottom(pugi::xml_node root) {
    SvgScanner box(root.attribute("viewBox").value());
    std::array<Real, 4> numbers{};
    std::size_t count = 0;
    box.skipSpace();
    for (std::optional<Real> number = box.takeNumber(); number; number = box.takeNumber()) {
        if (count < numbers.size()) numbers[count] = *number;
        ++count;
        box.skipSeparator();
    }
    if (count == numbers.size() && box.rest().empty()) {
        const Real bottom = numbers[1] + numbers[3];
        return std::abs(bottom) <= largestCoordinate ? bottom : 0;
    }
    return svgUserUnits(root.attribute("height").value()).value_or(0);
}

// Long or strange ids must not spoil the line that lists them.
std::string printable(const std::string& id) {
    constexpr std::size_t longest = 40;
    std::string text = id.size() > longest ? id.substr(0, longest) + "..." : id;
    std::replace_if(
        text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < ' '; }, ' ');
    return text;
}

// "#outline, #2, #handle": how each can be chosen. Only the first few, for a file may have thousands.
std::string listPaths(const SvgDocument& document, bool drawn) {
    constexpr std::size_t mostListed = 20;
    std::string list;
    std::size_t number = 0;
    for (const SvgPathElement& path : document.paths) {
        if (path.drawn != drawn || (!drawn && path.id.empty())) continue;
        if (++number > mostListed) continue;
        list += (list.empty() ? "#" : ", #") + (path.id.empty() ? std::to_string(number) : printable(path.id));
    }
    if (number > mostListed) list += " and " + std::to_string(number - mostListed) + " more";
    return list;
}

std::string whatElseIsThere(const SvgDocument& document) {
    std::string there;
    for (const auto& [name, count] : document.otherDrawings) {
        there += (there.empty() ? "" : ", ") + std::to_string(count) + " " + name;
    }
    if (!there.empty()) there = "; it draws " + there + ", to be converted to paths in the drawing program";
    const std::string hidden = listPaths(document, false);
    if (!hidden.empty()) there += "; not drawn, but may be chosen: " + hidden;
    return there;
}

const SvgPathElement* pathWithId(const SvgDocument& document, const std::string& id) {
    const auto found = std::find_if(document.paths.begin(), document.paths.end(),
                                    [&](const SvgPathElement& path) { return path.id == id; });
    return found == document.paths.end() ? nullptr : &*found;
}

}  // namespace

SvgDocument parseSvg(std::string_view text, const std::string& file) {
    checkIsText(text, file);
    if (text.size() > mostProfileBytes)
        throw InputError({file, 0}, "", "is larger than " + std::to_string(mostProfileBytes >> 20) + " MiB");
    checkMarkup(text, file);

    // Line ends stay as they are, so that lines within an attribute can be counted.
    std::string buffer(text);
    pugi::xml_document xml;
    const pugi::xml_parse_result parsed = xml.load_buffer_inplace(
        buffer.data(), buffer.size(), pugi::parse_escapes | pugi::parse_doctype | pugi::parse_pi | pugi::parse_cdata,
        pugi::encoding_utf8);
    if (parsed.status == pugi::status_no_document_element) throw InputError({file, 0}, "", "has no svg element");
    if (!parsed) {
        const auto offset = static_cast<std::size_t>(std::max<std::ptrdiff_t>(parsed.offset, 0));
        throw InputError({file, lineOf(text, offset)}, "",
                         std::string("is no well-formed XML: ") + parsed.description());
    }
    for (const pugi::xml_node node : xml.children()) {
        if (node.type() != pugi::node_doctype || std::string_view(node.value()).find("<!ENTITY") == std::string::npos)
            continue;
        throw InputError({file, lineOf(text, text.find("<!ENTITY"))}, "",
                         "declares entities, which are not expanded here; save it as plain SVG");
    }

    SvgDocument document;
    document.file = file;
    document.bottom = pageBottom(xml.document_element());
    findSvgPaths(text, buffer.data(), xml, document);
    return document;
}

std::vector<BezierSpline> svgSplines(const SvgPathElement& path) {
    if (!path.notFollowed.empty()) {
        throw InputError({path.dataPlace.file, path.line}, path.id,
                         "path depends on " + path.notFollowed + ", which is not followed here");
    }
    return parseSvgPathData(path.data, path.transform, path.dataPlace);
}

const SvgPathElement& chosenPath(const SvgDocument& document, const std::string& choice) {
    if (!choice.empty()) {
        if (const SvgPathElement* path = pathWithId(document, choice)) return *path;
    }
    std::vector<const SvgPathElement*> drawn;
    for (const SvgPathElement& path : document.paths) {
        if (path.drawn) drawn.push_back(&path);
    }
    if (drawn.empty()) throw InputError({document.file, 0}, choice, "draws no path" + whatElseIsThere(document));
    const std::string hint = listPaths(document, true);
    if (choice.empty()) {
        if (drawn.size() == 1) return *drawn.front();
        throw InputError({document.file, 0}, "", "has several paths; choose one of " + hint);
    }
    const auto number = parseInteger(choice).value_or(0);
    if (number < 1 || static_cast<std::size_t>(number) > drawn.size())
        throw InputError({document.file, 0}, choice, "has no such path; choose one of " + hint);
    return *drawn[static_cast<std::size_t>(number) - 1];
}

}  // namespace caustic
