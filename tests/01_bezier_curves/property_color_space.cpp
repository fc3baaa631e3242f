#include <gtest/gtest.h>

#include <cmath>

#include "core/random.h"
#include "image/color_space.h"

namespace caustic {
namespace {

// IEC 61966-2-1: the linear piece ends at 0.0031308, where it reads 12.92 · 0.0031308; mid-grey 0.5 is stored as 188.
TEST(ColorSpace, SrgbMeetsTheStandardsValues) {
    EXPECT_EQ(srgbEncode(Real(0)), 0);
    EXPECT_NEAR(srgbEncode(Real(1)), 1, 1e-15);
    EXPECT_NEAR(srgbEncode(0.0031308), 0.040449936, 1e-9);
    EXPECT_NEAR(srgbEncode(0.001), 0.01292, 1e-12) << "Is the part near black linear?";
    EXPECT_EQ(std::lround(255 * srgbEncode(0.5)), 188) << "Is it a power of 2.2 where it should be 2.4 with an offset?";
    EXPECT_NEAR(srgbEncode(0.18), 0.461356, 1e-6);
    EXPECT_NEAR(srgbDecode(0.5), 0.214041, 1e-6);
}

TEST(ColorSpace, SrgbIsContinuousWhereItsPiecesMeet) {
    EXPECT_NEAR(srgbEncode(0.0031308), srgbEncode(std::nextafter(0.0031308, 1)), 1e-7);
    EXPECT_NEAR(srgbDecode(0.04045), srgbDecode(std::nextafter(0.04045, 1)), 1e-7);
}

TEST(ColorSpace, SrgbBringsEveryCodeBack) {
    Real last = -1;
    for (int code = 0; code < 65536; ++code) {
        const Real linear = srgbDecode(code / Real(65535));
        ASSERT_EQ(std::lround(65535 * srgbEncode(linear)), code);
        ASSERT_GT(linear, last) << "Is the decoding monotonic?";
        last = linear;
    }
    for (int code = 0; code < 256; ++code) {
        ASSERT_EQ(std::lround(255 * srgbEncode(srgbDecode(code / Real(255)))), code);
    }
}

TEST(ColorSpace, SrgbClampsWhatNoDisplayShows) {
    EXPECT_EQ(srgbEncode(Real(-3)), 0);
    EXPECT_EQ(srgbEncode(std::nan("")), 0);
    EXPECT_EQ(srgbEncode(Real(7)), srgbEncode(Real(1)));
    EXPECT_EQ(srgbDecode(Real(-3)), 0);
    EXPECT_EQ(srgbDecode(Real(7)), 1);
}

TEST(ColorSpace, SrgbOfAColourIsItsChannels) {
    const Color color(0.1, 0.002, 0.9);
    for (int channel = 0; channel < 3; ++channel) {
        EXPECT_EQ(srgbEncode(color)[channel], srgbEncode(color[channel]));
        EXPECT_EQ(srgbDecode(color)[channel], srgbDecode(color[channel]));
    }
}

// The six corners of the hue hexagon: red, yellow, green, cyan, blue, magenta.
TEST(ColorSpace, HsvHasThePrimariesASixthOfATurnApart) {
    const Color expected[] = {{1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0, 1}, {1, 0, 1}};
    for (int i = 0; i < 6; ++i) {
        EXPECT_TRUE(hsvToRgb(i / Real(6), 1, 1).isApprox(expected[i], 1e-12)) << "corner " << i;
    }
}

TEST(ColorSpace, HsvIsPeriodicInHue) {
    Random random(1, {0});
    for (int i = 0; i < 1000; ++i) {
        const Real hue = random.uniform();
        const Real saturation = random.uniform();
        for (const Real turns : {-7, -1, 1, 12}) {
            EXPECT_TRUE(hsvToRgb(hue + turns, saturation, 0.8).isApprox(hsvToRgb(hue, saturation, 0.8), 1e-12));
        }
    }
}

// By definition V is the largest channel and S = (V - smallest) / V.
TEST(ColorSpace, HsvKeepsValueAndSaturation) {
    Random random(2, {0});
    for (int i = 0; i < 1000; ++i) {
        const Real saturation = random.uniform();
        const Real value = random.uniform(0.1, 3);
        const Color color = hsvToRgb(random.uniform(), saturation, value);
        EXPECT_NEAR(color.maxCoeff(), value, 1e-12);
        EXPECT_NEAR((value - color.minCoeff()) / value, saturation, 1e-12);
    }
}

// Smith's algorithm as usually printed: six sectors. An evaluation that shares nothing with ours.
TEST(ColorSpace, HsvAgreesWithTheSectorAlgorithm) {
    Random random(3, {0});
    for (int i = 0; i < 1000; ++i) {
        const Real h = random.uniform();
        const Real s = random.uniform();
        const Real v = random.uniform();
        const int sector = static_cast<int>(h * 6);
        const Real f = h * 6 - sector;
        const Real p = v * (1 - s);
        const Real q = v * (1 - s * f);
        const Real t = v * (1 - s * (1 - f));
        const Color sectors[] = {{v, t, p}, {q, v, p}, {p, v, t}, {p, q, v}, {t, p, v}, {v, p, q}};
        EXPECT_LT((hsvToRgb(h, s, v) - sectors[sector]).abs().maxCoeff(), 1e-12) << "hue " << h;
    }
}

}  // namespace
}  // namespace caustic
