#include <gtest/gtest.h>

#include "integrator/adaptive_rule.h"

namespace caustic {
namespace {

constexpr int width = 12;
constexpr int height = 7;

// Left of column 6 one colour, right of it another one.
PixelEstimates step(const Color& left, const Color& right) {
    PixelEstimates estimates(width, height);
    for (std::size_t i = 0; i < estimates.size(); ++i) estimates[i] = {1, i % width < 6 ? left : right, Color::Zero()};
    return estimates;
}

bool edgeAt(const std::vector<Real>& wanted, std::size_t x, std::size_t y) { return wanted[y * width + x] > 0; }

// A step is an edge on both of its sides and nowhere else, up to the picture's border; and in whatever channel it is.
TEST(EdgeRule, FindsStepsInAnyChannel) {
    const EdgeRule rule(0.1);
    for (const Color& right : {Color(3, 1, 1), Color(1, 3, 1), Color(1, 1, 3), Color(0, 1, 1)}) {
        const std::vector<Real> wanted = rule.wanted(step(Color::Ones(), right));
        ASSERT_EQ(wanted.size(), static_cast<std::size_t>(width * height));
        for (std::size_t y = 0; y < height; ++y) {
            for (std::size_t x = 0; x < width; ++x)
                ASSERT_EQ(edgeAt(wanted, x, y), x == 5 || x == 6)
                    << x << ", " << y << ": Is the largest of the channels compared, without its sign?";
        }
    }
    // A chessboard has edges everywhere, in its corners, too.
    PixelEstimates chessboard(width, height);
    for (std::size_t i = 0; i < chessboard.size(); ++i)
        chessboard[i] = {3, (i % width + i / width) % 2 == 0 ? Color(1, 2, 1) : Color(1, 0.1, 1), Color::Zero()};
    const std::vector<Real> everywhere = rule.wanted(chessboard);
    for (std::size_t i = 0; i < everywhere.size(); ++i)
        ASSERT_GT(everywhere[i], 0) << i % width << ", " << i / width << ": Is each pixel looked at, first and last?";
    // What is wanted goes with the Laplacian of v/(v + m): left and right of the step it is their difference.
    const Color left(1, 0.5, 4);
    const Color right(3, 5, 0.2);
    const Real mean = ((left + right) / 2).mean();
    const Real edge = (right / (right + mean) - left / (left + mean)).abs().maxCoeff();
    const std::vector<Real> exact = rule.wanted(step(left, right));
    for (std::size_t y = 0; y < height; ++y) {
        EXPECT_NEAR(exact[y * width + 5] / edge, 1, 1e-5)
            << "Which channel's edge, and compressed by which brightness?";
        EXPECT_NEAR(exact[y * width + 6] / edge, 1, 1e-5)
            << "Which channel's edge, and compressed by which brightness?";
    }
}

// The picture's brightness decides nothing, and a black picture has no edges.
TEST(EdgeRule, DoesNotCareHowBrightTheSceneIs) {
    const EdgeRule rule(0.1);
    const std::vector<Real> wanted = rule.wanted(step(Color(0.2, 1, 1), Color(2, 1, 0.4)));
    for (const Real scale : {1e-60, 1e-6, 1e5, 1e60}) {
        const std::vector<Real> scaled = rule.wanted(step(scale * Color(0.2, 1, 1), scale * Color(2, 1, 0.4)));
        for (std::size_t i = 0; i < wanted.size(); ++i)
            ASSERT_NEAR(scaled[i], wanted[i], 1e-5) << "Compressed by the picture's own mean?";
    }
    for (const Real want : rule.wanted(step(Color::Zero(), Color::Zero()))) ASSERT_EQ(want, 0);
    // A lamp a thousand times as bright beside it doesn't hide a step in the dark... nor is it a larger edge than any.
    const std::vector<Real> bright = rule.wanted(step(Color::Ones(), Color::Constant(1e4)));
    for (const Real want : bright) ASSERT_LE(want, 1) << "Compressed values lie between 0 and 1.";
    EXPECT_TRUE(edgeAt(bright, 5, 3));
}

// The steeper an edge, the sooner; and of equal ones that with the fewest paths. Below the threshold: nothing.
TEST(EdgeRule, AsksForSteepEdgesWithFewPathsFirst) {
    PixelEstimates estimates = step(Color::Ones(), Color(2, 2, 2));
    const EdgeRule rule(0.02);
    const std::vector<Real> before = rule.wanted(estimates);
    estimates[3 * width + 5].batches = 10;
    const std::vector<Real> after = rule.wanted(estimates);
    EXPECT_NEAR(after[3 * width + 5] / after[2 * width + 5], 0.1, 1e-12) << "It has ten times the batches.";
    const std::vector<Real> steeper = rule.wanted(step(Color::Ones(), Color(6, 6, 6)));
    EXPECT_GT(steeper[5], 1.2 * before[5]);
    for (const Real want : EdgeRule(0.9).wanted(step(Color::Ones(), Color(2, 2, 2)))) ASSERT_EQ(want, 0);
    // A third of the pixels is 3 and the others black: the mean is 1, and the edge 3/4, to the last digit.
    PixelEstimates third(width, height);
    for (std::size_t i = 0; i < third.size(); ++i)
        third[i] = {1, i % width < 4 ? Color(3, 3, 3) : Color::Zero(), Color::Zero()};
    for (const Real want : EdgeRule(0.75).wanted(third))
        ASSERT_EQ(want, 0) << "Larger than the threshold, or as large?";
    EXPECT_TRUE(edgeAt(EdgeRule(0.7499).wanted(third), 3, 2));
}

}  // namespace
}  // namespace caustic
