#include <gtest/gtest.h>

#include <numbers>

#include "core/error.h"
#include "core/random.h"
#include "image/image.h"
#include "image/laplacian.h"
#include "image/spherical_map.h"

namespace caustic {
namespace {

using std::numbers::pi;

// An image whose pixels are function(x, y) of the pixel's centre.
template <typename Function>
Image sampled(int width, int height, const Function& function) {
    Image image(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) image.set(x, y, function(x + 0.5, y + 0.5));
    }
    return image;
}

Color linear(Real x, Real y) { return {2 * x - 3 * y + 1, 0.5 * x, 8 - 0.25 * y}; }

Image noise(int width, int height) {
    Random random(7, {0});
    return sampled(width, height,
                   [&](Real, Real) { return Color(random.uniform(), random.uniform(), random.uniform()); });
}

TEST(Image, GivesBackWhatWasSet) {
    Image image(3, 2, Color(0.25, 0.5, 0.75));
    image.set(2, 1, Color(1, 2, 3));
    EXPECT_TRUE((image.at(2, 1) == Color(1, 2, 3)).all());
    EXPECT_TRUE((image.at(1, 1) == Color(0.25, 0.5, 0.75)).all());
    ASSERT_EQ(image.data().size(), 18U);
    EXPECT_EQ(image.data()[15], 1.0F) << "Are the rows contiguous, three floats a pixel?";
}

TEST(Image, RefusesSidesThatMakeNoImage) {
    EXPECT_THROW(Image(0, 5), InputError);
    EXPECT_THROW(Image(5, 0), InputError);
    EXPECT_THROW(Image(-1, 5), InputError);
    EXPECT_THROW(Image(1 << 20, 1 << 20), InputError);
    EXPECT_THROW(Image(2147483647, 2147483647), InputError);
}

TEST(Image, NearestIsThePixelThatCovers) {
    const Image image = noise(4, 3);
    Random random(8, {0});
    for (int i = 0; i < 1000; ++i) {
        const Real x = random.uniform(0, 4);
        const Real y = random.uniform(0, 3);
        ASSERT_TRUE((image.nearest(x, y) == image.at(static_cast<int>(x), static_cast<int>(y))).all());
    }
}

// Bilinear interpolation reproduces a linear function; the tolerance is that of the products' rounding.
TEST(Image, BilinearReproducesALinearFunction) {
    const Image image = sampled(9, 6, linear);
    Random random(9, {0});
    for (int i = 0; i < 1000; ++i) {
        const Real x = random.uniform(0.5, 8.5);
        const Real y = random.uniform(0.5, 5.5);
        ASSERT_LT((image.bilinear(x, y) - linear(x, y)).abs().maxCoeff(), 1e-13)
            << "Does a pixel's value stand at its centre, half a pixel from its corner?";
    }
}

TEST(Image, BilinearIsThePixelAtItsCentre) {
    const Image image = noise(5, 4);
    for (int y = 0; y < 4; ++y) {
        for (int x = 0; x < 5; ++x) EXPECT_TRUE((image.bilinear(x + 0.5, y + 0.5) == image.at(x, y)).all());
    }
}

TEST(Image, BilinearIsContinuousEverywhere) {
    const Image image = noise(5, 4);
    Random random(10, {0});
    constexpr Real step = 1e-9;
    for (int i = 0; i < 2000; ++i) {
        const Wrap wrap = i % 2 == 0 ? Wrap::Clamp : Wrap::Repeat;
        // A quarter of the places on the lattice of half pixels, where the four neighbours change.
        const auto place = [&] {
            const Real x = random.uniform(-6, 11);
            return random.below(4) == 0 ? std::round(2 * x) / 2 : x;
        };
        const Real x = place();
        const Real y = place();
        const Color here = image.bilinear(x, y, wrap, wrap);
        ASSERT_LT((image.bilinear(x + step, y, wrap, wrap) - here).abs().maxCoeff(), 4 * step) << x << ' ' << y;
        ASSERT_LT((image.bilinear(x, y - step, wrap, wrap) - here).abs().maxCoeff(), 4 * step) << x << ' ' << y;
    }
}

TEST(Image, ClampGoesOnWithTheBorder) {
    const Image image = noise(5, 4);
    EXPECT_TRUE((image.bilinear(-100, 1.5) == image.at(0, 1)).all());
    EXPECT_TRUE((image.bilinear(1e300, 1e300) == image.at(4, 3)).all());
    EXPECT_TRUE((image.nearest(-0.1, -1e300) == image.at(0, 0)).all());
    EXPECT_TRUE((image.nearest(5, 4) == image.at(4, 3)).all()) << "Does the right border belong to the last pixel?";
}

TEST(Image, RepeatTilesThePlane) {
    const Image image = noise(5, 4);
    Random random(11, {0});
    for (int i = 0; i < 1000; ++i) {
        const Real x = random.uniform(0, 5);
        const Real y = random.uniform(0, 4);
        const Color here = image.bilinear(x, y, Wrap::Repeat, Wrap::Repeat);
        ASSERT_LT((image.bilinear(x - 15, y + 8, Wrap::Repeat, Wrap::Repeat) - here).abs().maxCoeff(), 1e-12);
        ASSERT_TRUE((image.nearest(x, y, Wrap::Repeat, Wrap::Repeat) == image.nearest(x, y)).all());
    }
    EXPECT_TRUE((image.nearest(5, 4, Wrap::Repeat, Wrap::Repeat) == image.at(0, 0)).all());
}

TEST(Image, RepeatBlendsAcrossTheSeam) {
    const Image image = noise(5, 4);
    const Color seam = image.bilinear(0, 1.5, Wrap::Repeat, Wrap::Clamp);
    EXPECT_LT((seam - (image.at(4, 1) + image.at(0, 1)) / 2).abs().maxCoeff(), 1e-15)
        << "Halfway between the last column and the first one, which is next to it?";
}

TEST(Image, OnePixelIsItsColourEverywhere) {
    const Image image(1, 1, Color(0.5, 0.25, 2));
    for (const Wrap wrap : {Wrap::Clamp, Wrap::Repeat}) {
        EXPECT_TRUE((image.bilinear(0.1, 77.7, wrap, wrap) == image.at(0, 0)).all());
        EXPECT_TRUE((image.nearest(-3, 0.9, wrap, wrap) == image.at(0, 0)).all());
    }
}

// (x²)'' by central differences is exactly 2; so is that of 3x² - y² + xy: 6 - 2 + 0.
TEST(Laplacian, OfAQuadraticIsConstant) {
    const Image image = sampled(8, 7, [](Real x, Real y) { return Color(x * x, 3 * x * x - y * y + x * y, x * y); });
    const Image edges = laplacian(image);
    for (int y = 1; y < 6; ++y) {
        for (int x = 1; x < 7; ++x) EXPECT_TRUE(edges.at(x, y).isApprox(Color(2, 4, 0), 1e-12));
    }
}

TEST(Laplacian, OfAConstantIsZeroUpToTheBorder) {
    const Image edges = laplacian(Image(5, 4, Color(0.5, 0.25, 1)));
    for (const float value : edges.data()) EXPECT_EQ(value, 0.0F) << "Do the border's pixels go on beyond it?";
}

// What flows in at one pixel flows out at its neighbours: with the border going on, the sum over the image is zero.
TEST(Laplacian, SumsToZero) {
    const Image edges = laplacian(noise(16, 9));
    double sum = 0;
    for (const float value : edges.data()) sum += static_cast<double>(value);
    EXPECT_NEAR(sum, 0, 1e-5);
}

TEST(SphericalMap, LooksAlongTheAxesWhereTheConventionSays) {
    EXPECT_TRUE(sphericalToUv(Vec3(1, 0, 0)).isApprox(Vec2(0.5, 0.5), 1e-15));
    EXPECT_TRUE(sphericalToUv(Vec3(0, -1, 0)).isApprox(Vec2(0.75, 0.5), 1e-15)) << "Is the panorama mirrored?";
    EXPECT_TRUE(sphericalToUv(Vec3(0, 1, 0)).isApprox(Vec2(0.25, 0.5), 1e-15));
    EXPECT_EQ(sphericalToUv(Vec3(0, 0, 2)).y(), 0) << "Is the zenith the top row?";
    EXPECT_EQ(sphericalToUv(Vec3(0, 0, -0.5)).y(), 1);
    EXPECT_NEAR(sphericalToUv(Vec3(-1, 1e-300, 0)).x(), 0, 1e-15);
    EXPECT_NEAR(sphericalToUv(Vec3(-1, -1e-300, 0)).x(), 1, 1e-15);
}

TEST(SphericalMap, GoesThereAndBack) {
    Random random(12, {0});
    for (int i = 0; i < 1000; ++i) {
        const Vec2 uv(random.uniform(), random.uniform(0.001, 0.999));
        const Vec3 direction = uvToSpherical(uv);
        ASSERT_NEAR(direction.norm(), 1, 1e-14);
        ASSERT_LT((sphericalToUv(3.7 * direction) - uv).norm(), 1e-12);
    }
}

// Near a pole the angle is as good as anywhere: an arc cosine would lose half the digits there.
TEST(SphericalMap, KeepsTheAngleNearThePoles) {
    for (const Real theta : {1e-3, 1e-6, 1e-9, 1e-12}) {
        const Vec2 uv = sphericalToUv(Vec3(std::sin(theta), 0, std::cos(theta)));
        EXPECT_NEAR(uv.y() * pi / theta, 1, 1e-12) << "Does the angle come from its cosine?";
    }
}

// A panorama that holds at each pixel the direction that it shows: looking up a direction must give it back, up to the
// error of linear interpolation, h²/8 · max|f''| per axis, with h = 2π/256 and |f''| <= 1 (and half a row at the
// poles).
TEST(SphericalMap, FindsTheDirectionThatIsPaintedThere) {
    constexpr int width = 256;
    constexpr int height = 128;
    const Image panorama = sampled(
        width, height, [](Real x, Real y) { return Color(uvToSpherical(Vec2(x / width, y / height)).array()); });
    const Real h = 2 * pi / width;
    Random random(13, {0});
    for (int i = 0; i < 10000; ++i) {
        const Real z = random.uniform(-1, 1);
        const Real phi = random.uniform(-pi, pi);
        const Vec3 direction(std::sqrt(1 - z * z) * std::cos(phi), std::sqrt(1 - z * z) * std::sin(phi), z);
        const Real theta = std::acos(z);
        const bool atPole = theta < h || theta > pi - h;
        const Real allowed = atPole ? h : 2 * h * h / 8 + 1e-6;
        ASSERT_LT((lookUpSpherical(panorama, direction).matrix() - direction).norm(), allowed)
            << direction.transpose() << ": is the seam at -x where the columns wrap?";
    }
}

TEST(SphericalMap, HasNoSeam) {
    const Image panorama = noise(16, 8);
    for (Real z = -0.95; z < 1; z += 0.1) {
        const Color left = lookUpSpherical(panorama, Vec3(-1, 1e-12, z));
        const Color right = lookUpSpherical(panorama, Vec3(-1, -1e-12, z));
        EXPECT_LT((left - right).abs().maxCoeff(), 1e-10) << "Are the first and the last column neighbours?";
    }
}

// Rows must not wrap: the sky at the zenith knows nothing of the ground at the nadir.
TEST(SphericalMap, PolesDoNotMix) {
    const Image panorama = sampled(8, 4, [](Real, Real y) { return y < 2 ? Color(1, 1, 1) : Color(0, 0, 0); });
    EXPECT_TRUE((lookUpSpherical(panorama, Vec3(0, 0, 1)) == Color(1, 1, 1)).all());
    EXPECT_TRUE((lookUpSpherical(panorama, Vec3(0, 0, -1)) == Color(0, 0, 0)).all());
    EXPECT_TRUE((lookUpSpherical(panorama, Vec3(1e-9, 1e-9, 1)) == Color(1, 1, 1)).all());
}

}  // namespace
}  // namespace caustic
