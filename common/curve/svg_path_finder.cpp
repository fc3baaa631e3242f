#include "curve/svg_path_finder.h"

#include <algorithm>
#include <array>
#include <string>

#include "core/text.h"
#include "curve/profile_limits.h"
#include "curve/svg_namespaces.h"
#include "curve/svg_scanner.h"
#include "curve/svg_style.h"

namespace caustic {

namespace {

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

bool isOneOf(std::string_view name, std::initializer_list<std::string_view> names) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

// What an element hands down to its children.
struct Scope {
    SvgTransform transform = SvgTransform::Identity();
    bool drawn = true;         // for good: nothing inside can undo it
    bool visible = true;       // visibility, which an element inside may turn on again
    bool isSwitch = false;     // draws one child
    bool switchTaken = false;  // and has drawn it
    std::string notFollowed;
};

// CSS that moves what is drawn and has no counterpart among SVG's attributes.
constexpr std::array<std::string_view, 8> otherDisplacements = {"translate",   "rotate",          "scale", "offset",
                                                                "offset-path", "offset-distance", "zoom",  "d"};

// An element's properties: a style goes before an attribute.
class Properties {
public:
    explicit Properties(pugi::xml_node element) : element_(element), style_(element.attribute("style").value()) {}

    std::string_view style(std::string_view property) const { return style_.value(property); }
    std::string_view either(const char* property) const {
        const std::string_view styled = style_.value(property);
        return styled.empty() ? trimmed(element_.attribute(property).value()) : styled;
    }

private:
    pugi::xml_node element_;
    SvgStyle style_;
};

// Walks over the tree without recursion: a file decides how deep it goes.
class PathFinder {
public:
    PathFinder(std::string_view text, const char* buffer, SvgDocument& document)
        : buffer_(buffer), lines_(text), document_(&document) {}

    void find(const pugi::xml_document& xml) {
        for (const pugi::xml_node node : xml.children()) {
            const bool sheet = node.type() == pugi::node_pi && std::string_view(node.name()) == "xml-stylesheet";
            if (sheet) everywhere_ = "a style sheet in another file";
        }
        const pugi::xml_node root = xml.document_element();
        enter(root);
        for (pugi::xml_node node = root; !scopes_.empty();) {
            const pugi::xml_node child = firstElement(node.first_child());
            if (child) enter(child);
            node = child ? child : leaveForNext(node);
        }
        for (SvgPathElement& path : document_->paths) {
            if (path.notFollowed.empty()) path.notFollowed = everywhere_;
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
        const bool outermost = scopes_.empty();
        if (outermost) checkIsSvg(element, name);
        Scope scope = outermost ? Scope() : scopes_.back();
        scope.isSwitch = name == "switch";
        scope.switchTaken = false;
        if (!name.empty()) {
            const Properties properties(element);
            if (!outermost) applyConditions(element, scopes_.back(), scope);
            applyVisibility(properties, scope);
            applyTransforms(element, properties, outermost, scope);
            noteWhatChangesAll(element, name);
        }
        if (name == "svg" && !outermost) applyViewport(element, scope);
        if (name == "path") {
            addPath(element, scope);
        } else if (scope.drawn && scope.visible &&
                   isOneOf(name,
                           {"rect", "circle", "ellipse", "line", "polyline", "polygon", "use", "text", "image"})) {
            ++document_->otherDrawings[std::string(name)];
        }
        if (!isOneOf(name, {"svg", "g", "a", "switch"})) scope.drawn = false;
        scopes_.push_back(std::move(scope));
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

    // What needs an extension isn't drawn; a switch draws the first child that needs none. SVG 2, 5.9.
    static void applyConditions(pugi::xml_node element, Scope& around, Scope& scope) {
        const bool needsExtension = !element.attribute("requiredExtensions").empty();
        if (needsExtension || around.switchTaken) scope.drawn = false;
        if (element.attribute("systemLanguage")) scope.notFollowed = "a language (systemLanguage)";
        if (around.isSwitch && !needsExtension) around.switchTaken = true;
    }

    static void applyVisibility(const Properties& properties, Scope& scope) {
        const std::string_view display = properties.either("display");
        if (display == "none") scope.drawn = false;
        if (display == "contents") scope.notFollowed = "display: contents";
        const std::string_view visibility = properties.either("visibility");
        if (isOneOf(visibility, {"hidden", "collapse"})) scope.visible = false;
        if (isOneOf(visibility, {"visible", "initial"})) scope.visible = true;
    }

    void applyTransforms(pugi::xml_node element, const Properties& properties, bool outermost, Scope& scope) {
        for (const std::string_view property : otherDisplacements) {
            if (isOneOf(properties.style(property), {"", "none"})) continue;
            scope.notFollowed = std::string(property) + " in a style";
        }
        const auto own = ownTransform(element, properties);
        if (!own) {
            scope.notFollowed = "transform: " + std::string(properties.style("transform")) + " in a style";
            return;
        }
        if (own->matrix() == SvgTransform::Identity().matrix()) return;
        if (outermost) scope.notFollowed = "a transform of the outermost svg element";
        if (!isOneOf(properties.either("transform-box"), {"", "view-box"}))
            scope.notFollowed = "transform-box: " + std::string(properties.either("transform-box"));
        const auto origin = originOf(properties);
        if (!origin) {
            scope.notFollowed = "transform-origin: " + std::string(properties.either("transform-origin"));
            return;
        }
        scope.transform.translate(*origin);
        scope.transform = scope.transform * *own;
        scope.transform.translate(-*origin);
    }

    // That of the style goes before the attribute. Nothing when it can't be followed.
    std::optional<SvgTransform> ownTransform(pugi::xml_node element, const Properties& properties) {
        const std::string_view styled = properties.style("transform");
        if (!styled.empty()) return parseCssTransform(styled, placeOf(element.attribute("style")));
        const pugi::xml_attribute attribute = element.attribute("transform");
        if (!attribute) return SvgTransform::Identity();
        return parseSvgTransform(attribute.value(), placeOf(attribute));
    }

    static std::optional<Vec2> originOf(const Properties& properties) {
        const bool styled = !properties.style("transform-origin").empty();
        const std::string_view value = properties.either("transform-origin");
        return value.empty() ? Vec2::Zero().eval() : parseTransformOrigin(value, styled);
    }

    // Style sheets and animations may reach any path.
    void noteWhatChangesAll(pugi::xml_node element, std::string_view name) {
        if (name == "style") {
            std::string sheet;
            for (const pugi::xml_node text : element.children()) sheet += text.value();
            const std::string found = geometryInStyleSheet(sheet);
            if (!found.empty()) everywhere_ = found + " in a style sheet";
        }
        const bool moves = isOneOf(name, {"animateTransform", "animateMotion"});
        const bool sets = isOneOf(name, {"animate", "set"}) &&
                          isOneOf(element.attribute("attributeName").value(), {"d", "display", "visibility", "x", "y"});
        if (moves || sets) everywhere_ = "an animation (" + std::string(name) + ")";
    }

    static void applyViewport(pugi::xml_node svg, Scope& scope) {
        const auto x = svgUserUnits(svg.attribute("x").as_string("0"));
        const auto y = svgUserUnits(svg.attribute("y").as_string("0"));
        if (svg.attribute("viewBox")) scope.notFollowed = "a nested svg element with a viewBox";
        if (!x || !y) {
            scope.notFollowed = "a nested svg element with x or y in units";
        } else {
            scope.transform.translate(Vec2(*x, *y));
        }
    }

    void addPath(pugi::xml_node element, const Scope& scope) {
        SvgPathElement path;
        path.id = element.attribute("id").value();
        path.line = lineOfElement(element);
        path.drawn = scope.drawn && scope.visible;
        path.transform = scope.transform;
        path.notFollowed = scope.notFollowed;
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
    SvgNamespaces namespaces_;
    std::vector<Scope> scopes_;
    std::string everywhere_;  // what may change any path and is not followed
};

}  // namespace

void findSvgPaths(std::string_view text, const char* buffer, const pugi::xml_document& xml, SvgDocument& document) {
    PathFinder(text, buffer, document).find(xml);
}

}  // namespace caustic
