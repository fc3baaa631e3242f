#include <gtest/gtest.h>

#include <cmath>

#include "core/random.h"
#include "support/chi_square.h"
#include "texture/image_distribution.h"

namespace caustic {
namespace {

// Rows of a sphere hold less near the poles.
Real onSphere(Real v) { return (1 - std::cos(v * 3.14159265358979323846)) / 2; }
Real onPlane(Real v) { return v; }

// Lopsided and coloured, with black pixels among the others and one that outshines them.
Image uglyImage(int width, int height, std::uint64_t seed) {
    Random random(seed, {1});
    Image image(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            if (random.uniform() < 0.3) continue;
            image.set(x, y, Color(random.uniform(), 3 * random.uniform(), 0.2 * random.uniform()));
        }
    }
    image.set(width / 3, height / 2, Color(2, 9, 30));
    return image;
}

struct Case {
    Image image;
    Wrap wrapX;
    Wrap wrapY;
    Real (*heightOf)(Real);
};

std::vector<Case> cases() {
    return {{uglyImage(7, 4, 1), Wrap::Repeat, Wrap::Clamp, onSphere},
            {uglyImage(3, 8, 2), Wrap::Repeat, Wrap::Repeat, onPlane},
            {uglyImage(5, 5, 3), Wrap::Clamp, Wrap::Clamp, onPlane},
            {uglyImage(9, 3, 4), Wrap::Clamp, Wrap::Clamp, onSphere}};
}

// Integral over a rectangle of the unit square by midpoints.
Real integral(const ImageDistribution& distribution, const Vec2& low, const Vec2& high, int perAxis) {
    Real sum = 0;
    for (int i = 0; i < perAxis * perAxis; ++i) {
        const Vec2 place((i % perAxis + 0.5) / perAxis, (i / perAxis + 0.5) / perAxis);
        sum += distribution.pdf(low + place.cwiseProduct(high - low));
    }
    return sum * (high - low).prod() / (perAxis * perAxis);
}

// Pixels' centres and the borders, as shares of the whole; between them the density is bilinear.
std::vector<Real> nodesOf(int size, Real (*heightOf)(Real)) {
    std::vector<Real> nodes = {0};
    for (int i = 0; i < size; ++i) nodes.push_back(heightOf((i + 0.5) / size));
    nodes.push_back(1);
    return nodes;
}

// A density is one: all of it together is 1, on a plane as on a sphere. So the mean is that of the brightness by area.
TEST(ImageDistribution, DensityIntegratesToOne) {
    for (const Case& one : cases()) {
        const ImageDistribution distribution(one.image, one.wrapX, one.wrapY, one.heightOf);
        EXPECT_NEAR(integral(distribution, {0, 0}, {1, 1}, 1500), 1, 2e-3)
            << "A cell's weight: how bright is it in the mean of its four corners, and how large?";
        // In a cell's middle a bilinear function has its mean.
        const std::vector<Real> us = nodesOf(one.image.width(), onPlane);
        const std::vector<Real> hs = nodesOf(one.image.height(), one.heightOf);
        Real sum = 0;
        for (std::size_t row = 0; row + 1 < hs.size(); ++row) {
            for (std::size_t column = 0; column + 1 < us.size(); ++column)
                sum += distribution.pdf({(us[column] + us[column + 1]) / 2, (hs[row] + hs[row + 1]) / 2}) *
                       (us[column + 1] - us[column]) * (hs[row + 1] - hs[row]);
        }
        EXPECT_NEAR(sum, 1, 1e-9)
            << "A cell's weight: how bright is it in the mean of its four corners, and how large?";
    }
}

// What sample says of a place is what pdf says, at any place and scale of brightness.
TEST(ImageDistribution, SamplesSayTheirDensity) {
    for (const Case& one : cases()) {
        const ImageDistribution distribution(one.image, one.wrapX, one.wrapY, one.heightOf);
        Random random(5, {2});
        for (int i = 0; i < 2000; ++i) {
            const auto sample = distribution.sample({random.uniform(), random.uniform()});
            ASSERT_GT(sample.pdf, 0);
            ASSERT_NEAR(sample.pdf / distribution.pdf(sample.at), 1, 1e-6)
                << "The cell's probability over its area, times what varies within it: is one of the three missing?";
            ASSERT_NEAR(sample.pdf, distribution.pdf(sample.at), 1e-9) << "To the last digits?";
        }
        for (int i = 0; i < 200; ++i) {
            const Vec2 u(random.uniform(), random.uniform());
            const Vec2 step = distribution.sample(u + Vec2(1e-10, 1e-10)).at - distribution.sample(u).at;
            ASSERT_TRUE(step.x() != 0 && step.y() != 0) << "Have places as many digits as the numbers?";
        }
    }
}

// Counts in a grid that has nothing to do with the pixels, beside the integrals of pdf.
TEST(ImageDistribution, SamplesFollowTheDensity) {
    constexpr int columns = 11;
    constexpr int rows = 6;
    constexpr int draws = 40'000;
    for (const Case& one : cases()) {
        const ImageDistribution distribution(one.image, one.wrapX, one.wrapY, one.heightOf);
        std::vector<double> observed(columns * rows);
        std::vector<double> expected(columns * rows);
        double all = 0;
        for (int cell = 0; cell < columns * rows; ++cell) {
            const Vec2 corner(cell % columns / Real(columns), cell / columns / Real(rows));
            const auto at = static_cast<std::size_t>(cell);
            expected[at] = integral(distribution, corner, corner + Vec2(1.0 / columns, 1.0 / rows), 60);
            all += expected[at];
        }
        for (double& count : expected) count *= draws / all;
        Random random(6, {3});
        for (int i = 0; i < draws; ++i) {
            const Real x = random.uniform();
            const auto sample = distribution.sample({x, random.uniform()});
            const int column = std::min(columns - 1, static_cast<int>(sample.at.x() * columns));
            const int row = std::min(rows - 1, static_cast<int>(sample.at.y() * rows));
            observed[static_cast<std::size_t>(row * columns + column)] += 1;
        }
        EXPECT_GT(test::chiSquareProbability(observed, expected), 1e-6)
            << "Within the cell: are the numbers that are left of the choice used, and is it bilinear there?";
    }
}

}  // namespace
}  // namespace caustic
