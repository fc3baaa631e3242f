#pragma once

#include <optional>
#include <pugixml.hpp>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace caustic {

/// Which namespace a prefix means, element by element; the empty prefix is the default namespace.
/// Source: Namespaces in XML 1.0, 6.
class SvgNamespaces {
public:
    /// Takes up the declarations of an element, before its name is asked for.
    void enter(pugi::xml_node element);
    /// Gives them up again.
    void leave(pugi::xml_node element);

    /// The name without prefix of an element if it belongs to SVG, or else nothing. A file that declares no namespace
    /// at all is taken for SVG, as a person would.
    std::string_view svgName(pugi::xml_node element) const;

private:
    std::unordered_map<std::string_view, std::vector<std::string_view>> bindings_;
};

}  // namespace caustic
