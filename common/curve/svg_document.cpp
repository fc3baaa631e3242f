#include "curve/svg_document.h"

#include <algorithm>
#include <array>
#include <optional>
#include <pugixml.hpp>
#include <unordered_map>

#include "core/text.h"
#include "curve/profile_limits.h"
#include "curve/svg_path_data.h"

namespace caustic {

namespace {

constexpr std::string_view svgNamespace = "http://www.w3.org/2000/svg";

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

// Turns offsets into lines, counting on from the offset asked for last: they are asked for nearly in order.
class LineCounter {
public:
    explicit LineCounter(std::string_view text) : text_(text) {}

    std::size_t lineAt(std::size_t offset) {
        const std::size_t low = std::min(offset, offset_);
        const std::size_t lines = lineOf(text_.substr(low), std::max(offset, offset_) - low) - 1;
        line_ = offset < offset_ ? line_ - lines : line_ + lines;
        offset_ = offset;
        return line_;
    }

private:
    std::string_view text_;
    std::size_t offset_ = 0;
    std::size_t line_ = 1;
};

// Which namespace a prefix means; the empty prefix is the default namespace.
class Namespaces {
public:
    void enter(pugi::xml_node element) {
        for (const pugi::xml_attribute attribute : element.attributes()) {
            if (const auto prefix = declaredPrefix(attribute)) bindings_[*prefix].push_back(attribute.value());
        }
    }

    void leave(pugi::xml_node element) {
        for (const pugi::xml_attribute attribute : element.attributes()) {
            if (const auto prefix = declaredPrefix(attribute)) bindings_[*prefix].pop_back();
        }
    }

    // The element's name without prefix if it belongs to SVG, or else nothing. A file that declares no namespace at
    // all is taken for SVG, as a person would.
    std::string_view svgName(pugi::xml_node element) const {
        const std::string_view full = element.name();
        const std::size_t colon = full.find(':');
        const bool prefixed = colon != std::string_view::npos;
        const auto found = bindings_.find(prefixed ? full.substr(0, colon) : std::string_view());
        if (found == bindings_.end() || found->second.empty()) return prefixed ? std::string_view() : full;
        if (found->second.back() != svgNamespace) return {};
        return prefixed ? full.substr(colon + 1) : full;
    }

private:
    static std::optional<std::string_view> declaredPrefix(pugi::xml_attribute attribute) {
        constexpr std::string_view declaration = "xmlns";
        std::string_view name = attribute.name();
        if (!name.starts_with(declaration)) return std::nullopt;
        name.remove_prefix(declaration.size());
        if (name.empty()) return name;
        if (name.front() != ':') return std::nullopt;
        return name.substr(1);
    }

    std::unordered_map<std::string_view, std::vector<std::string_view>> bindings_;
};

bool isOneOf(std::string_view name, std::initializer_list<std::string_view> names) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

// The value of a property in a style attribute ("fill:none;transform:scale(2)"); empty when it isn't there.
std::string_view styleProperty(std::string_view style, std::string_view property) {
    while (!style.empty()) {
        const std::string_view item = style.substr(0, style.find(';'));
        style.remove_prefix(std::min(style.size(), item.size() + 1));
        const std::size_t colon = item.find(':');
        if (colon == std::string_view::npos || trimmed(item.substr(0, colon)) != property) continue;
        return trimmed(item.substr(colon + 1));
    }
    return {};
}

// A length in user units: a plain number, or one in px, which is the same.
std::optional<Real> userUnits(std::string_view text) {
    text = trimmed(text);
    if (text.ends_with("px")) text.remove_suffix(2);
    const auto value = parseReal(text);
    return value && std::abs(*value) <= largestCoordinate ? value : std::nullopt;
}

// What an element hands down to its children.
struct Scope {
    SvgTransform transform = SvgTransform::Identity();
    bool drawn = true;
    const char* displacedBy = "";
};

// Walks over the tree without recursion: a file decides how deep it goes.
class PathFinder {
public:
    PathFinder(std::string_view text, const char* buffer, SvgDocument& document)
        : buffer_(buffer), lines_(text), document_(&document) {}

    void find(pugi::xml_node root) {
        enter(root);
        for (pugi::xml_node node = root; !scopes_.empty();) {
            const pugi::xml_node child = firstElement(node.first_child());
            if (child) enter(child);
            node = child ? child : leaveForNext(node);
        }
    }

private:
    static pugi::xml_node firstElement(pugi::xml_node node) {
        while (node && node.type() != pugi::node_element) node = node.next_sibling();
        return node;
    }

    // Leaves the element, and those around it that it ends, for the one that follows and is entered.
    pugi::xml_node leaveForNext(pugi::xml_node element) {
        for (leave(element); !scopes_.empty(); leave(element)) {
            if (const pugi::xml_node next = firstElement(element.next_sibling())) {
                enter(next);
                return next;
            }
            element = element.parent();
        }
        return {};
    }

    void enter(pugi::xml_node element) {
        namespaces_.enter(element);
        const std::string_view name = namespaces_.svgName(element);
        Scope scope = scopes_.empty() ? Scope() : scopes_.back();
        const bool outermost = scopes_.empty();
        if (outermost) checkIsSvg(element, name);
        if (!name.empty()) applyTransforms(element, scope);
        if (name == "svg" && !outermost) applyViewport(element, scope);
        if (name == "path") {
            addPath(element, scope);
        } else if (scope.drawn && isOneOf(name, {"rect", "circle", "ellipse", "line", "polyline", "polygon", "use",
                                                 "text", "image"})) {
            ++document_->otherDrawings[std::string(name)];
        }
        if (!isOneOf(name, {"svg", "g", "a", "switch"})) scope.drawn = false;
        scopes_.push_back(scope);
    }

    void leave(pugi::xml_node element) {
        namespaces_.leave(element);
        scopes_.pop_back();
    }

    void checkIsSvg(pugi::xml_node root, std::string_view name) {
        if (name == "svg") return;
        throw InputError({document_->file, lineOfElement(root)}, root.name(),
                         "is XML, but no SVG: its root is not svg");
    }

    void applyTransforms(pugi::xml_node element, Scope& scope) {
        if (const pugi::xml_attribute attribute = element.attribute("transform")) {
            scope.transform = scope.transform * parseSvgTransform(attribute.value(), placeOf(attribute));
        }
        const std::string_view inStyle = styleProperty(element.attribute("style").value(), "transform");
        if (!inStyle.empty() && inStyle != "none") scope.displacedBy = "a transform in a style attribute";
    }

    static void applyViewport(pugi::xml_node svg, Scope& scope) {
        const auto x = userUnits(svg.attribute("x").as_string("0"));
        const auto y = userUnits(svg.attribute("y").as_string("0"));
        if (svg.attribute("viewBox")) scope.displacedBy = "a nested svg element with a viewBox";
        if (!x || !y) {
            scope.displacedBy = "a nested svg element with x or y in units";
        } else {
            scope.transform.translate(Eigen::Matrix<Real, 2, 1>(*x, *y));
        }
    }

    void addPath(pugi::xml_node element, const Scope& scope) {
        SvgPathElement path;
        path.id = element.attribute("id").value();
        path.line = lineOfElement(element);
        path.drawn = scope.drawn;
        path.transform = scope.transform;
        path.displacedBy = scope.displacedBy;
        path.dataPlace = {document_->file, path.line};
        if (const pugi::xml_attribute data = element.attribute("d")) {
            path.data = data.value();
            path.dataPlace = placeOf(data);
        }
        document_->paths.push_back(std::move(path));
    }

    std::size_t lineOfElement(pugi::xml_node element) {
        return lines_.lineAt(static_cast<std::size_t>(element.offset_debug()));
    }

    // Attributes were parsed in place, so a value stands in the buffer where it stood in the text.
    InputPlace placeOf(pugi::xml_attribute attribute) {
        return {document_->file, lines_.lineAt(static_cast<std::size_t>(attribute.value() - buffer_))};
    }

    const char* buffer_;
    LineCounter lines_;
    SvgDocument* document_;
    Namespaces namespaces_;
    std::vector<Scope> scopes_;
};

Real pageBottom(pugi::xml_node root) {
    std::string box = root.attribute("viewBox").value();
    std::replace(box.begin(), box.end(), ',', ' ');
    std::array<std::optional<Real>, 4> numbers;
    std::string_view rest = trimmed(box);
    for (auto& number : numbers) {
        const std::string_view word = rest.substr(0, rest.find_first_of(" \t\r\n"));
        number = userUnits(word);
        rest = trimmed(rest.substr(word.size()));
    }
    if (numbers[1] && numbers[3] && rest.empty()) return *numbers[1] + *numbers[3];
    return userUnits(root.attribute("height").value()).value_or(0);
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
        buffer.data(), buffer.size(), pugi::parse_escapes | pugi::parse_doctype, pugi::encoding_utf8);
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
    PathFinder(text, buffer.data(), document).find(xml.document_element());
    return document;
}

std::vector<BezierSpline> svgSplines(const SvgPathElement& path) {
    if (!path.displacedBy.empty()) {
        throw InputError({path.dataPlace.file, path.line}, path.id,
                         "path is displaced by " + path.displacedBy + ", which is not followed here");
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
