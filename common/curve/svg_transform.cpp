#include "curve/svg_transform.h"

#include <cmath>
#include <numbers>
#include <string>

// GCC 12 believes that Spirit's number parser looks at a number that it has not read.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
#include <svgpp/parser/grammar/transform.hpp>

namespace caustic {

namespace {

Real radians(Real degrees) { return std::remainder(degrees, Real(360)) * std::numbers::pi / 180; }

// What svgpp calls for each item of the list. Each one applies to what follows it, so it multiplies from the right.
class TransformBuilder {
public:
    const SvgTransform& result() const { return result_; }

    void transform_matrix(const boost::array<Real, 6>& m) {
        SvgTransform item;
        item.matrix() << m[0], m[2], m[4], m[1], m[3], m[5];
        result_ = result_ * item;
    }
    void transform_translate(Real x, Real y) { result_.translate(Eigen::Matrix<Real, 2, 1>(x, y)); }
    void transform_translate(Real x) { transform_translate(x, 0); }
    void transform_scale(Real x, Real y) { result_.scale(Eigen::Matrix<Real, 2, 1>(x, y)); }
    void transform_scale(Real both) { transform_scale(both, both); }
    void transform_rotate(Real angle) { result_.rotate(Eigen::Rotation2D<Real>(radians(angle))); }
    void transform_rotate(Real angle, Real x, Real y) {
        transform_translate(x, y);
        transform_rotate(angle);
        transform_translate(-x, -y);
    }
    void transform_skew_x(Real angle) { skew(std::tan(radians(angle)), 0); }
    void transform_skew_y(Real angle) { skew(0, std::tan(radians(angle))); }

private:
    // x' = x + byY y, y' = byX x + y. (Eigen's shear takes the two the other way round.)
    void skew(Real byY, Real byX) { result_.shear(byX, byY); }

    SvgTransform result_ = SvgTransform::Identity();
};

// svgpp wants a separator between two numbers, where SVG 2 and optimisers do without: "translate(1-2)", "scale(.5.5)".
std::string withSeparators(std::string_view text) {
    const auto isDigit = [](char c) { return c >= '0' && c <= '9'; };
    std::string separated;
    bool fraction = false;  // whether the number under way has its point or exponent
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        const char before = i > 0 ? text[i - 1] : '(';
        const bool afterNumber = isDigit(before) || before == '.';
        if (afterNumber && (c == '-' || c == '+' || (c == '.' && fraction))) separated += ' ';
        const bool goesOn = isDigit(c) || ((c == 'e' || c == 'E') && afterNumber) || before == 'e' || before == 'E';
        fraction = c == '.' || c == 'e' || c == 'E' || (fraction && goesOn);
        separated += c;
    }
    return separated;
}

}  // namespace

SvgTransform parseSvgTransform(std::string_view text, const InputPlace& place) {
    using Grammar = svgpp::transform_grammar<const char*, TransformBuilder, Real>;
    static const Grammar grammar;
    const std::string separated = withSeparators(text);
    const char* rest = separated.data();
    const char* const end = rest + separated.size();
    TransformBuilder builder;
    boost::spirit::qi::phrase_parse(rest, end, grammar(boost::phoenix::ref(builder)), Grammar::skipper_type());
    if (rest != end) throw InputError(place, std::string(rest, end), "malformed transform from here on");

    const Real determinant = builder.result().linear().determinant();
    if (!builder.result().matrix().allFinite() || !std::isfinite(determinant))
        throw InputError(place, std::string(text), "transform is too large for a double");
    if (determinant == 0) throw InputError(place, std::string(text), "transform is singular: it flattens every path");
    return builder.result();
}

}  // namespace caustic
