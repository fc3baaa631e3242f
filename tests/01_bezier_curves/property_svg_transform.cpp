#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "core/random.h"
#include "core/text.h"
#include "curve/svg_transform.h"

namespace caustic {
namespace {

constexpr std::uint64_t seed = 20261126;
constexpr Real pi = std::numbers::pi;

SvgTransform transformOf(const std::string& text) { return parseSvgTransform(text, {"test.svg", 1}); }

SvgTransform matrix(Real a, Real b, Real c, Real d, Real e, Real f) {
    SvgTransform transform;
    transform.matrix() << a, c, e, b, d, f;
    return transform;
}

void expectSameMap(const std::string& text, const SvgTransform& expected) {
    EXPECT_LE((transformOf(text).matrix() - expected.matrix()).norm(), 1e-14 * (1 + expected.matrix().norm())) << text;
}

// SVG 1.1, 7.6.
TEST(SvgTransform, EachKindIsTheMatrixOfTheStandard) {
    const Real c = std::cos(pi / 6);
    expectSameMap("matrix(1 2 3 4 5 6)", matrix(1, 2, 3, 4, 5, 6));
    expectSameMap("translate(3)", matrix(1, 0, 0, 1, 3, 0));
    expectSameMap("translate(3,-4)", matrix(1, 0, 0, 1, 3, -4));
    expectSameMap("scale(2)", matrix(2, 0, 0, 2, 0, 0));
    expectSameMap("scale(2 -3)", matrix(2, 0, 0, -3, 0, 0));
    expectSameMap("rotate(30)", matrix(c, 0.5, -0.5, c, 0, 0));
    expectSameMap("rotate(-390)", matrix(c, -0.5, 0.5, c, 0, 0));
    expectSameMap("rotate(90 10 20)", matrix(0, 1, -1, 0, 30, 10));
    expectSameMap("skewX(45)", matrix(1, 0, 1, 1, 0, 0));
    expectSameMap("skewY(45)", matrix(1, 1, 0, 1, 0, 0));
    expectSameMap("", SvgTransform::Identity());
}

TEST(SvgTransform, ListsMultiplyFromTheLeft) {
    expectSameMap("translate(10 20) scale(2)", matrix(2, 0, 0, 2, 10, 20));
    expectSameMap("scale(2),translate(10 20)", matrix(2, 0, 0, 2, 20, 40));
    expectSameMap(" rotate(90) , scale(1 2)translate(1,0) ", matrix(0, 1, -2, 0, 0, 1));
}

TEST(SvgTransform, NumbersNeedNoSeparatorsWhereTheyCantBeMistaken) {
    expectSameMap("matrix(1-2+3.5.25-1e-2-3)", matrix(1, -2, 3.5, 0.25, -0.01, -3));
    expectSameMap("scale(.5.25)", matrix(0.5, 0, 0, 0.25, 0, 0));
    expectSameMap("translate( 1e1 , 2E+0 )", matrix(1, 0, 0, 1, 10, 2));
}

// Writes numbers, separators and white space in any way that the grammars of SVG 1.1 and SVG 2 allow.
class Speller {
public:
    explicit Speller(Random& random) : random_(&random) {}

    std::string space() {
        std::string text;
        for (auto count = chance(4) ? random_->below(3) : 0; count > 0; --count) text += " \t\n\r\f"[random_->below(5)];
        return text;
    }

    // A decimal number of few digits and its spelling; the value is that of the C library's reader.
    std::pair<std::string, Real> number() {
        const std::string whole = std::to_string(random_->below(chance(2) ? 10 : 1000));
        const std::string fraction = std::to_string(random_->below(1000));
        std::string text;
        switch (random_->below(4)) {
            case 0:
                text = whole;
                break;
            case 1:
                text = whole + ".";
                break;
            case 2:
                text = "." + fraction;
                break;
            default:
                text = whole + "." + fraction;
        }
        if (chance(3)) text += exponent();
        const std::array<const char*, 4> signs = {"", "", "-", "+"};
        text = signs[random_->below(4)] + text;
        return {text, std::strtod(text.c_str(), nullptr)};
    }

    // What stands between two numbers: nothing where the second can't be mistaken for a part of the first.
    std::string between(const std::string& first, const std::string& second) {
        const bool signedNext = second[0] == '-' || second[0] == '+';
        const bool pointNext = second[0] == '.' && first.find_first_of(".eE") != std::string::npos;
        if ((signedNext || pointNext) && chance(2)) return {};
        if (chance(2)) return space() + "," + space();
        return " " + space();
    }

    bool chance(std::uint64_t oneIn) { return random_->below(oneIn) == 0; }

private:
    std::string exponent() {
        const std::array<const char*, 6> beginnings = {"e", "E", "e-", "E+", "e-0", "e+0"};
        return beginnings[random_->below(6)] + std::to_string(random_->below(3));
    }

    Random* random_;
};

// Whole turns are exact to leave out, whatever the angle.
Real radians(Real degrees) { return std::remainder(degrees, Real(360)) / 180 * pi; }

// The matrices of SVG 1.1, 7.6, as the standard prints them.
Eigen::Matrix3d standardMatrix(const std::string& name, const std::vector<Real>& a) {
    Eigen::Matrix3d m = Eigen::Matrix3d::Identity();
    if (name == "matrix") m << a[0], a[2], a[4], a[1], a[3], a[5], 0, 0, 1;
    if (name == "translate") m << 1, 0, a[0], 0, 1, a.size() > 1 ? a[1] : 0, 0, 0, 1;
    if (name == "scale") m << a[0], 0, 0, 0, a.size() > 1 ? a[1] : a[0], 0, 0, 0, 1;
    if (name == "skewX") m << 1, std::tan(radians(a[0])), 0, 0, 1, 0, 0, 0, 1;
    if (name == "skewY") m << 1, 0, 0, std::tan(radians(a[0])), 1, 0, 0, 0, 1;
    if (name == "rotate") {
        const Real c = std::cos(radians(a[0]));
        const Real s = std::sin(radians(a[0]));
        m << c, -s, 0, s, c, 0, 0, 0, 1;
        if (a.size() == 3) {
            m = standardMatrix("translate", {a[1], a[2]}) * m * standardMatrix("translate", {-a[1], -a[2]});
        }
    }
    return m;
}

struct KnownList {
    std::string text;
    Eigen::Matrix3d matrix = Eigen::Matrix3d::Identity();
    Real size = 1;  // product of the items' norms: what rounding errors are relative to
};

KnownList randomList(Random& random) {
    struct Kind {
        const char* name;
        std::size_t count;
    };
    constexpr std::array<Kind, 10> kinds = {{{"matrix", 6},
                                             {"translate", 1},
                                             {"translate", 2},
                                             {"scale", 1},
                                             {"scale", 2},
                                             {"rotate", 1},
                                             {"rotate", 3},
                                             {"skewX", 1},
                                             {"skewY", 1},
                                             {"scale", 1}}};
    Speller speller(random);
    KnownList list;
    list.text = speller.space();
    const std::uint64_t items = 1 + random.below(3);
    for (std::uint64_t item = 0; item < items; ++item) {
        const Kind& kind = kinds[random.below(kinds.size())];
        if (item > 0) list.text += speller.space() + (speller.chance(2) ? "," : "") + speller.space();
        list.text += kind.name + speller.space() + "(" + speller.space();
        std::vector<Real> values;
        std::string last;
        for (std::size_t i = 0; i < kind.count; ++i) {
            const auto [text, value] = speller.number();
            list.text += (i > 0 ? speller.between(last, text) : "") + text;
            values.push_back(value);
            last = text;
        }
        list.text += speller.space() + ")";
        const Eigen::Matrix3d matrix = standardMatrix(kind.name, values);
        list.matrix = list.matrix * matrix;
        // A tangent's error grows with its square.
        list.size *= kind.name[0] == 's' && kind.name[1] == 'k' ? matrix.squaredNorm() : 1 + matrix.norm();
    }
    list.text += speller.space();
    return list;
}

TEST(SvgTransform, RandomListsInEverySpellingAreTheirMatrices) {
    int checked = 0;
    for (std::uint64_t i = 0; i < 20000; ++i) {
        Random random(seed, {i});
        const KnownList list = randomList(random);
        // Singular ones are refused, which is tested elsewhere.
        if (std::abs(list.matrix.topLeftCorner<2, 2>().determinant()) < 1e-9 || list.size > 1e9) continue;
        ++checked;
        const auto ours = transformOf(list.text).matrix();
        ASSERT_LE((ours - list.matrix.topRows<2>()).norm(), 1e-13 * list.size) << '"' << list.text << '"';
    }
    EXPECT_GT(checked, 15000) << "Are most lists left out?";
}

// The numbers that drawing programs write: a positive first one with a point. Millimetres in pixels are 25.4 / 96.
TEST(SvgTransform, FirstNumbersMayHavePoints) {
    expectSameMap("scale(1.7)", matrix(1.7, 0, 0, 1.7, 0, 0));
    expectSameMap("translate(1.5)", matrix(1, 0, 0, 1, 1.5, 0));
    expectSameMap("translate(0.5,2.25)", matrix(1, 0, 0, 1, 0.5, 2.25));
    expectSameMap("scale(0.26458333)", matrix(0.26458333, 0, 0, 0.26458333, 0, 0));
    expectSameMap("rotate(30.5)", matrix(std::cos(30.5 * pi / 180), std::sin(30.5 * pi / 180),
                                         -std::sin(30.5 * pi / 180), std::cos(30.5 * pi / 180), 0, 0));
}

TEST(SvgTransform, NumbersTooSmallForADoubleAreZero) {
    expectSameMap("translate(1e-400 -2e-999)", SvgTransform::Identity());
}

void expectSameCss(const std::string& css, const std::string& attribute) {
    const auto ours = parseCssTransform(css, {"test.svg", 1});
    ASSERT_TRUE(ours.has_value()) << css;
    EXPECT_LE((ours->matrix() - transformOf(attribute).matrix()).norm(), 1e-13) << css;
}

// CSS Transforms 1, 11; lengths by CSS Values 3, 6.2: an inch is 96 px.
TEST(CssTransform, HasUnitsAndFunctionsOfItsOwn) {
    expectSameCss("none", "");
    expectSameCss("matrix(1, 2, 3, 4, 5, 6)", "matrix(1 2 3 4 5 6)");
    expectSameCss("translate(3px)", "translate(3)");
    expectSameCss("translate( 1in , -2.54cm )", "translate(96 -96)");
    expectSameCss("translate(25.4mm, 101.6q)", "translate(96 96)");
    expectSameCss("translate(72pt, 6PC)", "translate(96 96)");
    expectSameCss("translateX(1.5px) translateY(0)", "translate(1.5 0)");
    expectSameCss("scale(2, -3)", "scale(2 -3)");
    expectSameCss("SCALE(2)", "scale(2)");
    expectSameCss("scaleX(2)scaleY(.5)", "scale(2 .5)");
    expectSameCss("rotate(90deg) rotate(.25turn) rotate(100grad) rotate(1.5707963267948966rad)", "rotate(360)");
    expectSameCss("rotate(0)", "");
    expectSameCss("skewX(45deg)", "skewX(45)");
    expectSameCss("skewY(-30deg)", "skewY(-30)");
    expectSameCss("skew(30deg, 20deg)", "matrix(1 0.36397023426620234 0.57735026918962576 1 0 0)");
}

TEST(CssTransform, WhatCantBeFollowedIsNoTransform) {
    for (const char* css :
         {"", "inherit", "translate(3)", "translate(50%)", "translate(1em)", "translate(1px 2px)", "rotate(30)",
          "rotate(30deg, 1, 2)", "rotate3d(1, 0, 0, 30deg)", "matrix(1 2 3 4 5 6)", "scale (2)", "scale(2),scale(2)",
          "perspective(3px)", "scale(2px)", "rotate(3px)", "translateX(1px, 2px)", "scale(calc(1 + 1))", "scale(2"}) {
        EXPECT_FALSE(parseCssTransform(css, {"test.svg", 1}).has_value()) << css;
    }
}

TEST(CssTransform, OriginsAreTwoLengths) {
    EXPECT_EQ(parseTransformOrigin("20 30", false), Vec2(20, 30));
    EXPECT_EQ(parseTransformOrigin(" -1.5px 0 ", true), Vec2(-1.5, 0));
    EXPECT_EQ(parseTransformOrigin("1in 2px 0", true), Vec2(96, 2));
    for (const char* origin : {"20 30", "center", "50% 50%", "20px", "1px 2px 3px", "left top", "1em 2em"}) {
        EXPECT_FALSE(parseTransformOrigin(origin, true).has_value()) << origin;
    }
    EXPECT_FALSE(parseTransformOrigin("20", false).has_value()) << "the second would be the middle of a box";
}

}  // namespace
}  // namespace caustic
