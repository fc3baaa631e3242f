#include "curve/svg_namespaces.h"

namespace caustic {

namespace {

constexpr std::string_view svgNamespace = "http://www.w3.org/2000/svg";

std::optional<std::string_view> declaredPrefix(pugi::xml_attribute attribute) {
    constexpr std::string_view declaration = "xmlns";
    std::string_view name = attribute.name();
    if (!name.starts_with(declaration)) return std::nullopt;
    name.remove_prefix(declaration.size());
    if (name.empty()) return name;
    if (name.front() != ':') return std::nullopt;
    return name.substr(1);
}

}  // namespace

void SvgNamespaces::enter(pugi::xml_node element) {
    for (const pugi::xml_attribute attribute : element.attributes()) {
        if (const auto prefix = declaredPrefix(attribute)) bindings_[*prefix].push_back(attribute.value());
    }
}

void SvgNamespaces::leave(pugi::xml_node element) {
    for (const pugi::xml_attribute attribute : element.attributes()) {
        if (const auto prefix = declaredPrefix(attribute)) bindings_[*prefix].pop_back();
    }
}

std::string_view SvgNamespaces::svgName(pugi::xml_node element) const {
    const std::string_view full = element.name();
    const std::size_t colon = full.find(':');
    const bool prefixed = colon != std::string_view::npos;
    const auto found = bindings_.find(prefixed ? full.substr(0, colon) : std::string_view());
    if (found == bindings_.end() || found->second.empty()) return prefixed ? std::string_view() : full;
    if (found->second.back() != svgNamespace) return {};
    return prefixed ? full.substr(colon + 1) : full;
}

}  // namespace caustic
