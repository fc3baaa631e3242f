#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/error.h"
#include "core/random.h"
#include "core/text.h"
#include "curve/profile_file.h"
#include "curve/profile_limits.h"
#include "curve/profile_text.h"
#include "support/paths.h"
#include "support/temporary_folder.h"

namespace caustic {
namespace {

constexpr std::uint64_t seed = 20260102;

// Any finite double that a profile may have: signs, subnormals and all exponents.
Real randomCoordinate(Random& random) {
    while (true) {
        const auto bits = (random.below(std::uint64_t{1} << 32) << 32) | random.below(std::uint64_t{1} << 32);
        const auto value = std::bit_cast<Real>(bits);
        if (std::abs(value) <= largestCoordinate) return value;
    }
}

std::vector<std::uint64_t> bitsOf(const BezierSpline& spline) {
    std::vector<std::uint64_t> bits;
    for (const BezierCurve& segment : spline.segments()) {
        for (const Vec3& point : segment.controlPoints()) {
            for (const Real coordinate : point) bits.push_back(std::bit_cast<std::uint64_t>(coordinate));
        }
    }
    return bits;
}

BezierSpline parse(const std::string& text) { return parseProfileText(text, "profile.txt"); }

std::string messageOf(const std::string& text) {
    try {
        parse(text);
    } catch (const InputError& error) {
        return error.what();
    }
    return "no error";
}

constexpr const char* fourPoints = "0 0\n1 2\n3 4\n5 6\n";

TEST(ProfileText, WritingThenReadingIsTheIdentityToTheLastBit) {
    for (std::uint64_t i = 0; i < 2000; ++i) {
        Random random(seed, {1, i});
        const bool flat = i % 2 == 0;
        std::vector<Vec3> points(3 * (1 + i % 7) + 1);
        for (Vec3& point : points) {
            point = {randomCoordinate(random), randomCoordinate(random), flat ? 0 : randomCoordinate(random)};
        }
        const BezierSpline spline = BezierSpline::fromControlPoints(points, i % 3 == 0);
        const BezierSpline back = parse(profileText(spline));
        ASSERT_EQ(bitsOf(back), bitsOf(spline)) << profileText(spline);
        ASSERT_EQ(back.closed(), spline.closed());
    }
}

TEST(ProfileText, ANegativeZeroKeepsItsSign) {
    const std::vector<Vec3> points(4, Vec3(-0.0, 0, -0.0));
    const BezierSpline spline = BezierSpline::fromControlPoints(points);
    EXPECT_EQ(bitsOf(parse(profileText(spline))), bitsOf(spline));
}

TEST(ProfileText, SavedFilesReadBack) {
    const test::TemporaryFolder folder;
    const BezierSpline spline = parse(fourPoints);
    saveProfileText(spline, folder.path() / "new/glass.txt");
    EXPECT_EQ(bitsOf(loadProfile((folder.path() / "new/glass.txt").string())), bitsOf(spline));
}

TEST(ProfileText, CommentsBlankLinesTabsByteOrderMarkAndForeignLineEndsDontMatter) {
    const auto expected = bitsOf(parse(fourPoints));
    EXPECT_EQ(bitsOf(parse("\xEF\xBB\xBF# glass\r\n\r\n 0\t0\r\n1   2 # lip\r\n3 4\r\n\n5 6")), expected);
    EXPECT_EQ(bitsOf(parse("0 0 0\n1 2\n3 4 0\n+5 6e0")), expected) << "two and three columns may be mixed";
}

TEST(ProfileText, ASplineWithAGapIsRefused) {
    const BezierSpline spline(
        {BezierCurve({Vec3(0, 0, 0), Vec3(1, 0, 0)}), BezierCurve({Vec3(2, 0, 0), Vec3(3, 0, 0)})});
    EXPECT_THROW(profileText(spline), InputError);
}

TEST(ProfileText, ErrorsNameFileLineValueAndReason) {
    EXPECT_EQ(messageOf("0 0\n# note\n1 two\n"), "profile.txt:3: must be a number that a double can hold (got 'two')");
    EXPECT_EQ(messageOf("0 1e400\n"), "profile.txt:1: must be a number that a double can hold (got '1e400')");
    EXPECT_EQ(messageOf("0 nan\n"), "profile.txt:1: must be a finite number (got 'nan')");
    EXPECT_EQ(messageOf("-inf 0\n"), "profile.txt:1: must be a finite number (got '-inf')");
    EXPECT_EQ(messageOf("0 2e100\n"), "profile.txt:1: must not be larger than 1e+100 (got '2e100')");
    EXPECT_EQ(messageOf("\n5\n"), "profile.txt:2: a control point has two or three coordinates (got '5')");
    EXPECT_EQ(messageOf("1 2 3 4\n"), "profile.txt:1: a control point has two or three coordinates (got '1 2 3 4')");
    EXPECT_EQ(messageOf("1,2\n"), "profile.txt:1: must be a number that a double can hold (got '1,2')");
    EXPECT_EQ(messageOf("0 0\n1 1\n2 2\n3 3\n4 4\n"),
              "profile.txt:5: n cubic segments need 3n + 1 control points: 4, 7, 10, ... (got '5 points')");
    EXPECT_EQ(messageOf("0 0\n1 1\n2 2\nclosed\n3 3\n"), "profile.txt:5: nothing may follow 'closed' (got '3 3')");
    EXPECT_EQ(messageOf(""), "profile.txt: is empty: no control point, no SVG");
    EXPECT_EQ(messageOf("# only a comment"), "profile.txt: is empty: no control point, no SVG");
    EXPECT_EQ(messageOf(std::string("0 0\n\0001 1", 8)), "profile.txt:2: is no text: it has a zero byte");
    EXPECT_EQ(messageOf(std::string("\xFF\xFE\x30\0\x20\0", 6)),
              "profile.txt:1: is encoded in UTF-16; save it as UTF-8");
    EXPECT_EQ(messageOf(std::string("\0\x30\0\x20", 4)), "profile.txt:1: is encoded in UTF-16; save it as UTF-8");
}

constexpr const char* twoPaths =
    "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 -5 100 50'>"
    "<path id='glass' d='M0 45 C1 45 2 44 3 40'/><path d='M0 0 L1 1 M5 5 L6 6'/></svg>";

// Page from y = -5 to 45: its lower edge becomes y = 0.
TEST(LoadProfile, AnSvgPageIsTurnedOverOnItsLowerEdge) {
    const test::TemporaryFolder folder;
    const std::string file = folder.write("two.svg", twoPaths).string();
    const std::vector<Vec3> expected = {{0, 0, 0}, {1, 0, 0}, {2, 1, 0}, {3, 5, 0}};
    EXPECT_EQ(loadProfile(file + "#glass").controlPoints(), expected);
    EXPECT_EQ(loadProfile(file + "#1").controlPoints(), expected);
}

TEST(LoadProfile, WithoutViewBoxTheHeightSaysWhereThePageEnds) {
    const test::TemporaryFolder folder;
    const auto lastY = [&](const std::string& attributes) {
        const std::string path = "<svg " + attributes + "><path d='M0 0 L0 30'/></svg>";
        return loadProfile(folder.write("page.svg", path).string()).position(1).y();
    };
    EXPECT_EQ(lastY("height='100'"), 70);
    EXPECT_EQ(lastY("height='100px'"), 70);
    EXPECT_EQ(lastY("height='100mm'"), -30) << "a length that is not in user units doesn't say";
    EXPECT_EQ(lastY("viewBox='0,0, 40,50' height='100'"), 20);
    EXPECT_EQ(lastY(""), -30);
}

TEST(LoadProfile, ContentDecidesWhatAFileIsNotItsName) {
    const test::TemporaryFolder folder;
    EXPECT_EQ(loadProfile(folder.write("really_text.svg", fourPoints).string()).segments().size(), 1U);
    EXPECT_EQ(loadProfile(folder.write("really_svg.txt", twoPaths).string() + "#glass").segments().size(), 1U);
}

TEST(LoadProfile, ANumberSignInTheNameOfAFileChoosesNothing) {
    const test::TemporaryFolder folder;
    EXPECT_EQ(loadProfile(folder.write("glass#1.txt", fourPoints).string()).segments().size(), 1U);
}

TEST(LoadProfile, BadChoicesAreRefused) {
    const test::TemporaryFolder folder;
    const std::string svg = folder.write("two.svg", twoPaths).string();
    const std::string text = folder.write("points.txt", fourPoints).string();
    const auto messageOfLoading = [](const std::string& name) -> std::string {
        try {
            loadProfile(name);
        } catch (const InputError& error) {
            return error.what();
        }
        return "no error";
    };
    EXPECT_EQ(messageOfLoading(svg), svg + ": has several paths; choose one of #glass, #2");
    EXPECT_EQ(messageOfLoading(svg + "#cup"), svg + ": has no such path; choose one of #glass, #2 (got 'cup')");
    EXPECT_EQ(messageOfLoading(svg + "#3"), svg + ": has no such path; choose one of #glass, #2 (got '3')");
    EXPECT_EQ(messageOfLoading(svg + "#0"), svg + ": has no such path; choose one of #glass, #2 (got '0')");
    EXPECT_EQ(messageOfLoading(svg + "#2"), svg + ":1: path has 2 subpaths; a profile is one curve");
    EXPECT_EQ(messageOfLoading(text + "#1"),
              text + ": a file of control points has one curve, nothing to choose (got '1')");
}

// The course's own profiles are to be revolved about x = 0 (chapter 03).
class ProfileAsset : public testing::TestWithParam<const char*> {
protected:
    BezierSpline profile() const { return loadProfile((test::sourceDir() / "assets/profiles" / GetParam()).string()); }
};

TEST_P(ProfileAsset, RunsFromTheAxisToTheAxisWithoutCrossingIt) {
    const BezierSpline spline = profile();
    const Real end = static_cast<Real>(spline.segments().size());
    EXPECT_EQ(spline.position(0).x(), 0);
    EXPECT_EQ(spline.position(end).x(), 0);
    EXPECT_LT(spline.position(0).y(), spline.position(end).y()) << "it begins at the bottom, y upwards";
    for (const BezierCurve& segment : spline.segments()) {
        for (const Vec3& point : segment.controlPoints()) EXPECT_GE(point.x(), 0) << "a radius is never negative";
    }
}

TEST_P(ProfileAsset, StandsOnYZero) { EXPECT_NEAR(profile().bounds().min().y(), 0, 1e-9); }

TEST_P(ProfileAsset, IsSmooth) {
    for (const Joint& joint : profile().joints()) EXPECT_GE(joint.continuity, Continuity::G1);
}

// Horizontal where it meets the axis, or the revolved surface would have a spike there.
TEST_P(ProfileAsset, MeetsTheAxisAtARightAngle) {
    const BezierSpline spline = profile();
    EXPECT_EQ(spline.segments().front().tangent(0), Vec3(1, 0, 0));
    EXPECT_EQ(spline.segments().back().tangent(1), Vec3(-1, 0, 0));
}

INSTANTIATE_TEST_SUITE_P(All, ProfileAsset,
                         testing::Values("wine_glass.svg", "wine_glass.txt", "vase.svg", "teacup.svg"),
                         [](const auto& parameter) {
                             std::string name = parameter.param;
                             std::replace(name.begin(), name.end(), '.', '_');
                             return name;
                         });

TEST(ProfileAssets, WineGlassIsTheSameAsDrawingAndAsText) {
    const std::string folder = (test::sourceDir() / "assets/profiles").string();
    const auto drawn = loadProfile(folder + "/wine_glass.svg").controlPoints();
    const auto typed = loadProfile(folder + "/wine_glass.txt").controlPoints();
    ASSERT_EQ(drawn->size(), typed->size());
    for (std::size_t i = 0; i < drawn->size(); ++i) {
        EXPECT_LE(((*drawn)[i] - (*typed)[i]).norm(), 1e-12) << "point " << i;
    }
}

// Numbers that its layers' transforms give by hand: a foot of radius 34 at y = 0 and 131 high; a flame of 34 × 6.75,
// enlarged by 1.5 around a wick at 40, moved down by 1 cm of 96/2.54 pixels, and made narrower by 0.9.
TEST(ProfileAssets, CandlestickStandsWhereItsLayersPutIt) {
    const std::string file = (test::sourceDir() / "assets/profiles/candlestick.svg").string();
    const Bounds3 stick = loadProfile(file + "#profile").bounds();
    EXPECT_NEAR(stick.min().y(), 0, 1e-9);
    EXPECT_NEAR(stick.max().y(), 131, 1e-9);
    EXPECT_NEAR(stick.max().x(), 34, 1e-9);
    const Bounds3 flame = loadProfile(file + "#flame").bounds();
    EXPECT_NEAR(flame.min().y(), 200 - 40 - 96 / 2.54, 1e-9) << "the wick";
    EXPECT_NEAR(flame.max().y() - flame.min().y(), 1.5 * 34, 1e-9);
    EXPECT_NEAR(flame.min().x(), 0, 1e-9);
    EXPECT_NEAR(flame.max().x(), 1.5 * 0.9 * 6.75, 1e-9);
    try {
        loadProfile(file);
        FAIL() << "two paths are drawn";
    } catch (const InputError& error) {
        EXPECT_EQ(std::string(error.what()), file + ": has several paths; choose one of #profile, #flame")
            << "Is the hidden sketch left out?";
    }
}

}  // namespace
}  // namespace caustic
