#include "curve/svg_transform.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "core/text.h"
#include "curve/svg_scanner.h"

namespace caustic {

namespace {

constexpr Real degree = std::numbers::pi / 180;

enum class Syntax { Attribute, Css };
enum class Quantity { Number, Length, Angle };

// A function of the list: what its arguments are and how many it may have.
struct Function {
    std::string_view name;
    Quantity quantity;
    std::size_t least;
    std::size_t most;
    bool cssOnly = false;
};

constexpr std::array functions = {Function{"matrix", Quantity::Number, 6, 6},
                                  Function{"translate", Quantity::Length, 1, 2},
                                  Function{"scale", Quantity::Number, 1, 2},
                                  Function{"rotate", Quantity::Angle, 1, 3},
                                  Function{"skewx", Quantity::Angle, 1, 1},
                                  Function{"skewy", Quantity::Angle, 1, 1},
                                  Function{"translatex", Quantity::Length, 1, 1, true},
                                  Function{"translatey", Quantity::Length, 1, 1, true},
                                  Function{"scalex", Quantity::Number, 1, 1, true},
                                  Function{"scaley", Quantity::Number, 1, 1, true},
                                  Function{"skew", Quantity::Angle, 1, 2, true}};

struct Unit {
    std::string_view name;
    Quantity quantity;
    Real size;  // in pixels or degrees
};

constexpr std::array units = {Unit{"px", Quantity::Length, 1},         Unit{"in", Quantity::Length, 96},
                              Unit{"cm", Quantity::Length, 96 / 2.54}, Unit{"mm", Quantity::Length, 96 / 25.4},
                              Unit{"q", Quantity::Length, 96 / 101.6}, Unit{"pt", Quantity::Length, 96.0 / 72},
                              Unit{"pc", Quantity::Length, 16},        Unit{"deg", Quantity::Angle, 1},
                              Unit{"grad", Quantity::Angle, 0.9},      Unit{"rad", Quantity::Angle, 1 / degree},
                              Unit{"turn", Quantity::Angle, 360}};

std::string lowered(std::string_view text) {
    std::string lower(text);
    std::ranges::transform(lower, lower.begin(), [](char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; });
    return lower;
}

// A number with its unit, in user units or degrees. CSS needs the unit, except after a 0.
std::optional<Real> takeQuantity(SvgScanner& scanner, Quantity quantity, Syntax syntax) {
    const std::optional<Real> number = scanner.takeNumber();
    if (!number || syntax == Syntax::Attribute) return number;
    const std::string unit = lowered(scanner.takeWord());
    if (unit.empty()) return quantity == Quantity::Number || *number == 0 ? number : std::nullopt;
    const auto* const found = std::ranges::find(units, unit, &Unit::name);
    if (found == units.end() || found->quantity != quantity) return std::nullopt;
    return *number * found->size;
}

// Exact where degrees are multiples of 90, so that a quarter turn doesn't leave 6e-17 behind.
Vec2 cosSin(Real degrees) {
    const Real turned = std::remainder(degrees, Real(360));
    if (std::remainder(turned, Real(90)) != 0) return {std::cos(turned * degree), std::sin(turned * degree)};
    const auto quarters = static_cast<int>(std::round(turned / 90));
    return {Real(quarters == 0) - Real(std::abs(quarters) == 2), Real(quarters == 1) - Real(quarters == -1)};
}

Real tangent(Real degrees) { return std::tan(std::remainder(degrees, Real(360)) * degree); }

SvgTransform matrix(Real a, Real b, Real c, Real d, Real e, Real f) {
    SvgTransform transform;
    transform.matrix() << a, c, e, b, d, f;
    return transform;
}

SvgTransform translation(Real x, Real y) { return matrix(1, 0, 0, 1, x, y); }

SvgTransform rotation(Real degrees) {
    const Vec2 turn = cosSin(degrees);
    return matrix(turn.x(), turn.y(), -turn.y(), turn.x(), 0, 0);
}

// The matrix of a function: SVG 1.1, 7.6; CSS Transforms 1, 11.1 and 12.
SvgTransform matrixOf(std::string_view name, const std::array<Real, 6>& a, std::size_t count) {
    if (name == "matrix") return matrix(a[0], a[1], a[2], a[3], a[4], a[5]);
    if (name == "translate" || name == "translatex") return translation(a[0], a[1]);
    if (name == "translatey") return translation(0, a[0]);
    if (name == "scale") return matrix(a[0], 0, 0, count == 1 ? a[0] : a[1], 0, 0);
    if (name == "scalex") return matrix(a[0], 0, 0, 1, 0, 0);
    if (name == "scaley") return matrix(1, 0, 0, a[0], 0, 0);
    if (name == "skewx") return matrix(1, 0, tangent(a[0]), 1, 0, 0);
    if (name == "skewy") return matrix(1, tangent(a[0]), 0, 1, 0, 0);
    if (name == "skew") return matrix(1, tangent(a[1]), tangent(a[0]), 1, 0, 0);
    return translation(a[1], a[2]) * rotation(a[0]) * translation(-a[1], -a[2]);  // rotate; (a1, a2) is 0 if not given
}

// Names are case-sensitive in the attribute only.
const Function* takeFunction(SvgScanner& scanner, Syntax syntax) {
    const std::string_view word = scanner.takeWord();
    const std::string lower = lowered(word);
    const auto* const found = std::ranges::find(functions, lower, &Function::name);
    if (found == functions.end()) return nullptr;
    if (syntax == Syntax::Css) return found;
    const std::string_view spelt = lower == "skewx" ? "skewX" : lower == "skewy" ? "skewY" : found->name;
    return found->cssOnly || word != spelt ? nullptr : found;
}

// One function with its arguments; nothing when it is malformed.
std::optional<SvgTransform> takeItem(SvgScanner& scanner, Syntax syntax) {
    const Function* const function = takeFunction(scanner, syntax);
    if (function == nullptr) return std::nullopt;
    if (syntax == Syntax::Attribute) scanner.skipSpace();
    if (!scanner.take('(')) return std::nullopt;
    std::array<Real, 6> values{};
    std::size_t count = 0;
    for (scanner.skipSpace(); !scanner.take(')'); ++count) {
        if (count > 0 && syntax == Syntax::Css && scanner.next() != ',') return std::nullopt;
        if (count > 0) scanner.skipSeparator();
        const auto value = count < function->most ? takeQuantity(scanner, function->quantity, syntax) : std::nullopt;
        if (!value) return std::nullopt;
        values[count] = *value;
        scanner.skipSpace();
    }
    // Only the attribute's rotate has a centre, and then both its coordinates.
    const bool rotate = function->name == "rotate";
    if (count < function->least || (rotate && (count == 2 || (count == 3 && syntax == Syntax::Css))))
        return std::nullopt;
    return matrixOf(function->name, values, count);
}

// The whole list. On return the scanner stands at the first item that is malformed, or at the end.
SvgTransform takeList(SvgScanner& scanner, Syntax syntax) {
    SvgTransform result = SvgTransform::Identity();
    scanner.skipSpace();
    while (scanner.next() != '\0') {
        const std::size_t begin = scanner.place();
        const std::optional<SvgTransform> item = takeItem(scanner, syntax);
        if (!item) {
            scanner.goTo(begin);
            break;
        }
        // Each one applies to what follows it, so it multiplies from the right.
        result = result * *item;
        scanner.skipSpace();
        const std::size_t end = scanner.place();
        while (syntax == Syntax::Attribute && scanner.take(',')) scanner.skipSpace();
        if (scanner.next() == '\0') scanner.goTo(end);  // a comma must be followed by something
        if (scanner.next() == ',') break;
    }
    return result;
}

void checkInvertible(const SvgTransform& transform, std::string_view text, const InputPlace& place) {
    const Real determinant = transform.linear().determinant();
    if (!transform.matrix().allFinite() || !std::isfinite(determinant))
        throw InputError(place, std::string(text), "transform is too large for a double");
    if (determinant == 0) throw InputError(place, std::string(text), "transform is singular: it flattens every path");
}

}  // namespace

SvgTransform parseSvgTransform(std::string_view text, const InputPlace& place) {
    SvgScanner scanner(text);
    const SvgTransform result = takeList(scanner, Syntax::Attribute);
    if (!scanner.rest().empty())
        throw InputError(place, std::string(scanner.rest()), "malformed transform from here on");
    checkInvertible(result, text, place);
    return result;
}

std::optional<SvgTransform> parseCssTransform(std::string_view text, const InputPlace& place) {
    if (lowered(trimmed(text)) == "none") return SvgTransform::Identity();
    SvgScanner scanner(text);
    const SvgTransform result = takeList(scanner, Syntax::Css);
    if (!scanner.rest().empty() || trimmed(text).empty()) return std::nullopt;
    checkInvertible(result, text, place);
    return result;
}

std::optional<Vec2> parseTransformOrigin(std::string_view text, bool css) {
    SvgScanner scanner(text);
    std::array<Real, 3> values{};
    std::size_t count = 0;
    for (scanner.skipSpace(); scanner.next() != '\0'; ++count) {
        if (count == values.size()) return std::nullopt;
        const std::size_t begin = scanner.place();
        auto value = takeQuantity(scanner, Quantity::Length, Syntax::Css);
        if (!value && !css) {
            scanner.goTo(begin);
            value = takeQuantity(scanner, Quantity::Length, Syntax::Attribute);
        }
        if (!value) return std::nullopt;
        values[count] = *value;
        scanner.skipSpace();
    }
    if (count < 2 || values[2] != 0) return std::nullopt;
    return Vec2(values[0], values[1]);
}

}  // namespace caustic
