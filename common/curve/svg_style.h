#pragma once

#include <map>
#include <string>
#include <string_view>

namespace caustic {

/// The declarations of a style attribute: "fill:none; transform: scale(2) !important".
///
/// Of two for one property the later holds, unless the earlier alone is important. Comments are passed over.
/// Source: CSS Style Attributes, 3; CSS Syntax 3, 5.4.
class SvgStyle {
public:
    explicit SvgStyle(std::string_view text);

    /// The value of a property, in lower case; empty when it isn't declared.
    /// @param property  in lower case
    std::string_view value(std::string_view property) const;

private:
    struct Declaration {
        std::string value;
        bool important = false;
    };

    void declare(std::string_view item);

    std::map<std::string, Declaration, std::less<>> declarations_;
};

/// The first of those properties in a style sheet that hide or displace what is drawn: display, visibility, transform,
/// d and the like, or an import rule, which could bring any of them; empty when there is none.
std::string geometryInStyleSheet(std::string_view sheet);

}  // namespace caustic
