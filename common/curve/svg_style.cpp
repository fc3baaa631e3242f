#include "curve/svg_style.h"

#include <algorithm>
#include <array>

#include "core/text.h"

namespace caustic {

namespace {

// In lower case, and with a blank for each comment.
std::string simplified(std::string_view css) {
    std::string simple;
    char quote = '\0';
    for (std::size_t i = 0; i < css.size(); ++i) {
        char c = css[i];
        if (quote == '\0' && css.substr(i, 2) == "/*") {
            i = std::min(css.find("*/", i + 2), css.size() - 1) + 1;
            c = ' ';
        } else if (c == quote) {
            quote = '\0';
        } else if (quote == '\0' && (c == '"' || c == '\'')) {
            quote = c;
        }
        simple += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    }
    return simple;
}

// How long the declaration is that text begins with: up to a semicolon that stands in no string and no parentheses.
std::size_t declarationLength(std::string_view text) {
    char quote = '\0';
    int depth = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (quote != '\0') {
            if (c == quote) quote = '\0';
        } else if (c == '"' || c == '\'') {
            quote = c;
        } else if (c == '(') {
            ++depth;
        } else if (c == ')') {
            --depth;
        } else if (c == ';' && depth <= 0) {
            return i;
        }
    }
    return text.size();
}

bool belongsToName(char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-' || c == '_' || c == '@';
}

}  // namespace

SvgStyle::SvgStyle(std::string_view text) {
    const std::string simple = simplified(text);
    for (std::string_view rest = simple; !rest.empty();) {
        const std::size_t length = declarationLength(rest);
        declare(rest.substr(0, length));
        rest.remove_prefix(std::min(rest.size(), length + 1));
    }
}

void SvgStyle::declare(std::string_view item) {
    const std::size_t colon = item.find(':');
    if (colon == std::string_view::npos) return;
    Declaration declaration;
    std::string_view value = trimmed(item.substr(colon + 1));
    const std::size_t mark = value.rfind('!');
    if (mark != std::string_view::npos && trimmed(value.substr(mark + 1)) == "important") {
        declaration.important = true;
        value = trimmed(value.substr(0, mark));
    }
    declaration.value = value;
    Declaration& held = declarations_[std::string(trimmed(item.substr(0, colon)))];
    if (!held.important || declaration.important) held = std::move(declaration);
}

std::string_view SvgStyle::value(std::string_view property) const {
    const auto found = declarations_.find(property);
    return found == declarations_.end() ? std::string_view() : std::string_view(found->second.value);
}

std::string geometryInStyleSheet(std::string_view sheet) {
    constexpr std::array<std::string_view, 16> geometry = {
        "display", "visibility", "transform", "transform-origin", "transform-box",   "translate",     "rotate",
        "scale",   "d",          "offset",    "offset-path",      "offset-distance", "offset-rotate", "offset-position",
        "zoom",    "all"};
    const std::string css = simplified(sheet);
    for (std::size_t i = 0; i < css.size();) {
        std::size_t end = i;
        while (end < css.size() && belongsToName(css[end])) ++end;
        const std::string_view name = std::string_view(css).substr(i, end - i);
        const std::size_t next = css.find_first_not_of(" \t\r\n\f", end);
        const bool declared = next != std::string::npos && css[next] == ':';
        if (name == "@import") return "@import";
        if (declared && std::ranges::find(geometry, name) != geometry.end()) return std::string(name);
        i = end == i ? i + 1 : end;
    }
    return {};
}

}  // namespace caustic
