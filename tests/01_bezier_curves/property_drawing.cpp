#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <numbers>
#include <opencv2/core.hpp>

#include "core/error.h"
#include "core/random.h"
#include "image/drawing.h"
#include "image/image_file.h"
#include "support/temporary_folder.h"

namespace caustic {
namespace {

using std::numbers::pi;

constexpr Ink black{0, 0, 0};
const Vec2 nowhere(std::numeric_limits<Real>::quiet_NaN(), 0);

// What is drawn in black on white: how much of it, and where its centre of gravity and its bounds lie, in pixels.
struct Coverage {
    Real area = 0;
    Vec2 centre = Vec2::Zero();
    Bounds2 bounds;
};

Coverage coverage(const Drawing& drawing) {
    Coverage found;
    const auto bgr = drawing.bgr();
    for (int y = 0; y < drawing.height(); ++y) {
        for (int x = 0; x < drawing.width(); ++x) {
            const auto i = static_cast<std::size_t>(3 * (y * drawing.width() + x));
            const Real share = 1 - bgr[i] / Real(255);
            if (share <= 0) continue;
            found.area += share;
            found.centre += share * Vec2(x + 0.5, y + 0.5);
            found.bounds.extend(Bounds2(Vec2(x, y), Vec2(x + 1, y + 1)));
        }
    }
    found.centre /= found.area;
    return found;
}

template <typename Draw>
Coverage drawn(const Draw& draw) {
    Drawing drawing(100, 80);
    draw(drawing);
    return coverage(drawing);
}

Ink pixel(const Drawing& drawing, int x, int y) {
    const auto bgr = drawing.bgr();
    const auto i = static_cast<std::size_t>(3 * (y * drawing.width() + x));
    return {bgr[i + 2], bgr[i + 1], bgr[i]};
}

// OpenCV paints a polygon's outline too, so that every edge lies up to one sample, a quarter of a pixel, too far out.
constexpr Real edgeError = 0.25;

TEST(Drawing, PaperIsThere) {
    const Drawing drawing(3, 2, palette::sky);
    EXPECT_EQ(drawing.width(), 3);
    EXPECT_EQ(drawing.height(), 2);
    EXPECT_EQ(pixel(drawing, 2, 1), palette::sky) << "Are red and blue in their places?";
}

TEST(Drawing, ClearPaintsEverythingOver) {
    Drawing drawing(20, 20);
    drawing.circle({10, 10}, 6, black);
    drawing.clear(palette::grid);
    EXPECT_EQ(drawing.bgr(), Drawing(20, 20, palette::grid).bgr());
}

TEST(Drawing, PolygonCoversItsArea) {
    Random random(41, {0});
    Vec2 shift = Vec2::Zero();
    constexpr int count = 200;
    for (int i = 0; i < count; ++i) {
        const auto corner = [&] { return Vec2(random.uniform(5, 95), random.uniform(5, 75)); };
        const Vec2 a = corner();
        const Vec2 b = corner();
        const Vec2 c = corner();
        const Real area = std::abs((b - a).x() * (c - a).y() - (b - a).y() * (c - a).x()) / 2;
        const Real outline = (b - a).norm() + (c - b).norm() + (a - c).norm();
        const Coverage found = drawn([&](Drawing& d) { d.polygon({a, b, c}, black); });
        EXPECT_NEAR(found.area, area, edgeError * outline + 0.5) << a.transpose() << ", " << b << ", " << c;
        shift += (found.centre - (a + b + c) / 3) / count;
    }
    EXPECT_LT(shift.norm(), 0.15) << "Is there a shift of half a pixel?";
}

TEST(Drawing, CircleCoversItsArea) {
    Random random(42, {0});
    for (int i = 0; i < 100; ++i) {
        const Vec2 centre(random.uniform(35, 65), random.uniform(35, 45));
        const Real radius = random.uniform(1, 30);
        const Coverage disc = drawn([&](Drawing& d) { d.circle(centre, radius, black); });
        EXPECT_NEAR(disc.area, pi * radius * radius, 0.1 * 2 * pi * radius + 0.5);
        EXPECT_LT((disc.centre - centre).norm(), 0.05) << "Is a place kept to a part of a pixel?";
        const Coverage ring = drawn([&](Drawing& d) { d.circle(centre, radius, Stroke{black, 2}); });
        EXPECT_LT((ring.centre - centre).norm(), 0.1);
        if (radius > 2) {
            EXPECT_NEAR(ring.area, 4 * pi * radius, edgeError * 2 * pi * radius + 0.5);
        }
    }
}

// Width times length, and a half disc at each end.
TEST(Drawing, LineIsAsWideAsItsStroke) {
    Random random(43, {0});
    for (const Real width : {1.0, 2.0, 3.5, 8.0}) {
        for (int i = 0; i < 30; ++i) {
            const Vec2 from(random.uniform(10, 90), random.uniform(10, 70));
            const Vec2 to(random.uniform(10, 90), random.uniform(10, 70));
            const Real length = (to - from).norm();
            const Coverage found = drawn([&](Drawing& d) { d.line(from, to, Stroke{black, width}); });
            EXPECT_NEAR(found.area, width * length + pi / 4 * width * width, edgeError * (length + 2 * width));
            EXPECT_LT((found.centre - (from + to) / 2).norm(), 0.3);
        }
    }
}

TEST(Drawing, DashesCoverHalf) {
    const Real solid = drawn([](Drawing& d) { d.line({2, 40}, {98, 40}, Stroke{black, 2}); }).area;
    const Coverage dashed = drawn([](Drawing& d) { d.line({2, 40}, {98, 40}, Stroke{black, 2, 8}); });
    // Six dashes of eight pixels, each with round ends.
    EXPECT_NEAR(dashed.area, 6 * (8 * 2 + pi), 8);
    EXPECT_LT(dashed.area, 0.7 * solid);
}

// Dashes go on round corners: their lengths don't start anew at each point of a curve.
TEST(Drawing, DashesHeedTheWholeWay) {
    std::vector<Vec2> fine;
    for (int i = 0; i <= 960; ++i) fine.push_back({2 + i * 0.1, 40});
    const auto line = [](const std::vector<Vec2>& points) {
        return drawn([&](Drawing& d) { d.polyline(points, Stroke{black, 2, 8}); });
    };
    EXPECT_NEAR(line(fine).area, line({{2, 40}, {98, 40}}).area, 6);
}

TEST(Drawing, ClosedPolylineComesBack) {
    const std::vector<Vec2> square = {{20, 20}, {60, 20}, {60, 60}, {20, 60}};
    const Real open = drawn([&](Drawing& d) { d.polyline(square, Stroke{black, 2}); }).area;
    const Real closed = drawn([&](Drawing& d) { d.polyline(square, Stroke{black, 2}, true); }).area;
    EXPECT_NEAR(closed - open, 2 * 40 - 2, 0.1 * 2 * 40);
    const Bounds2 box(Vec2(20, 20), Vec2(60, 60));
    EXPECT_EQ(drawn([&](Drawing& d) { d.rectangle(box, Stroke{black, 2}); }).area, closed);
}

TEST(Drawing, ArrowEndsAtItsTip) {
    const Coverage found = drawn([](Drawing& d) { d.arrow({20, 40}, {80, 40}, Stroke{black, 2}); });
    EXPECT_NEAR(found.bounds.max().x(), 80, 1);
    EXPECT_NEAR(found.bounds.min().x(), 19, 1);
    EXPECT_GT(found.bounds.sizes().y(), 8) << "Has it a head?";
    EXPECT_GT(found.centre.x(), 50);
    Drawing nothing(20, 20);
    nothing.arrow({5, 5}, {5, 5}, Stroke{black, 2});
    EXPECT_EQ(nothing.bgr(), Drawing(20, 20).bgr());
}

TEST(Drawing, AlphaLetsThePaperShine) {
    Drawing drawing(40, 40, palette::white);
    drawing.rectangle(Bounds2(Vec2(5, 5), Vec2(35, 35)), black.withAlpha(0.25));
    EXPECT_NEAR(pixel(drawing, 20, 20).red, 255 * 0.75, 1);
    EXPECT_EQ(pixel(drawing, 2, 2), palette::white);
    drawing.rectangle(Bounds2(Vec2(5, 5), Vec2(35, 35)), black.withAlpha(0));
    EXPECT_NEAR(pixel(drawing, 20, 20).red, 255 * 0.75, 1);
}

// A line that crosses itself is one shape: where it covers itself it isn't twice as dark.
TEST(Drawing, ATransparentLineIsOneShape) {
    Drawing drawing(60, 60);
    drawing.polyline({{10, 30}, {50, 30}, {30, 10}, {30, 50}}, Stroke{black.withAlpha(0.5), 6});
    EXPECT_NEAR(pixel(drawing, 30, 30).red, 128, 1);
    EXPECT_NEAR(pixel(drawing, 15, 30).red, 128, 1);
}

TEST(Drawing, WhatLiesOutsideIsCutOff) {
    Drawing drawing(50, 50);
    drawing.line({-1e5, 25}, {1e5, 25}, Stroke{black, 4});
    drawing.circle({-500, -500}, 100, black);
    drawing.circle({1e9, 1e9}, 3, black.withAlpha(0.5));
    drawing.polygon({{60, 60}, {1e7, 60}, {60, 1e7}}, black);
    drawing.text({45, 500}, "below", {});
    drawing.image(Image(2, 2), Bounds2(Vec2(100, 100), Vec2(200, 200)));
    EXPECT_NEAR(coverage(drawing).area, 4 * 50, 0.2 * 50);
}

TEST(Drawing, TextStandsWhereItsAnchorSays) {
    const auto text = [](HorizontalAnchor horizontal, VerticalAnchor vertical) {
        const TextStyle style{24, black, false, horizontal, vertical};
        return drawn([&](Drawing& d) { d.text({50, 40}, "HIH", style); }).bounds;
    };
    const Bounds2 left = text(HorizontalAnchor::Left, VerticalAnchor::Baseline);
    EXPECT_NEAR(left.min().x(), 52, 2);
    EXPECT_NEAR(left.max().y(), 40, 1) << "Does a letter stand on the base line?";
    // A capital letter of DejaVu Sans is 0.729 em high (its OS/2 table: 1493 of 2048).
    EXPECT_NEAR(left.sizes().y(), 0.729 * 24, 1.5);
    EXPECT_NEAR(text(HorizontalAnchor::Centre, VerticalAnchor::Middle).center().x(), 50, 1);
    EXPECT_NEAR(text(HorizontalAnchor::Centre, VerticalAnchor::Middle).center().y(), 40, 1);
    EXPECT_NEAR(text(HorizontalAnchor::Right, VerticalAnchor::Middle).max().x(), 50, 1);
}

TEST(Drawing, TextWidthIsWhatTheTextCovers) {
    Drawing drawing(600, 60);
    for (const bool bold : {false, true}) {
        const TextStyle style{30, black, bold};
        drawing.clear(palette::white);
        drawing.text({20, 40}, "P₀ … Grüße: α½ mm", style);
        EXPECT_NEAR(drawing.textWidth("P₀ … Grüße: α½ mm", style), coverage(drawing).bounds.max().x() - 20, 1.5);
    }
    EXPECT_EQ(drawing.textWidth("", {}), 0);
    EXPECT_NEAR(drawing.textWidth("xx", {40}), 2 * drawing.textWidth("xx", {20}), 1);
    EXPECT_GT(drawing.textWidth("curve", {20, black, true}), drawing.textWidth("curve", {20, black, false}));
}

TEST(Drawing, ImageFillsItsBoxUnsmoothed) {
    Image image(2, 2);
    image.set(0, 0, Color(1, 0, 0));
    image.set(1, 0, Color(0, 1, 0));
    image.set(0, 1, Color(0, 0, 1));
    image.set(1, 1, Color(0.5, 0.5, 0.5));
    Drawing drawing(50, 50);
    drawing.image(image, Bounds2(Vec2(10, 10), Vec2(30, 40)));
    EXPECT_EQ(pixel(drawing, 10, 10), (Ink{255, 0, 0}));
    EXPECT_EQ(pixel(drawing, 19, 24), (Ink{255, 0, 0}));
    EXPECT_EQ(pixel(drawing, 20, 24), (Ink{0, 255, 0}));
    EXPECT_EQ(pixel(drawing, 19, 25), (Ink{0, 0, 255}));
    EXPECT_EQ(pixel(drawing, 29, 39), (Ink{188, 188, 188})) << "Is the linear value encoded?";
    EXPECT_EQ(pixel(drawing, 30, 39), palette::white);
    EXPECT_EQ(pixel(drawing, 9, 10), palette::white);
}

void drawSomeOfAll(Drawing& drawing) {
    drawing.polyline({{5, 5}, {70, 60}, {90, 10}}, Stroke{palette::blue, 3, 5});
    drawing.circle({40, 40}, 20, palette::orange.withAlpha(0.4));
    drawing.arrow({5, 70}, {95, 50}, Stroke{palette::vermilion, 2});
    drawing.text({50, 40}, "same", {20, palette::green, true});
}

TEST(Drawing, SameCallsGiveTheSameBytesWhateverTheThreads) {
    const test::TemporaryFolder folder;
    std::vector<std::string> files;
    const int threads = cv::getNumThreads();
    for (const int count : {1, 2}) {
        cv::setNumThreads(count);
        Drawing drawing(100, 80);
        drawSomeOfAll(drawing);
        drawing.save(folder / "a.png");
        std::ifstream file(folder / "a.png", std::ios::binary);
        files.emplace_back(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
    }
    cv::setNumThreads(threads);
    EXPECT_EQ(files[0], files[1]);
}

TEST(Drawing, SavesWhatItShows) {
    const test::TemporaryFolder folder;
    Drawing drawing(100, 80);
    drawSomeOfAll(drawing);
    drawing.save(folder / "a.png");
    const Image image = loadImage(folder / "a.png", Encoding::Linear);
    ASSERT_EQ(image.width(), 100);
    const auto bgr = drawing.bgr();
    for (std::size_t i = 0; i < bgr.size(); ++i) {
        ASSERT_EQ(std::lround(255 * Real(image.data()[i / 3 * 3 + 2 - i % 3])), bgr[i]);
    }
}

TEST(Drawing, RefusesWhatCannotBeDrawn) {
    EXPECT_THROW(Drawing(0, 10), InputError);
    EXPECT_THROW(Drawing(10, Drawing::largestSide + 1), InputError);
    EXPECT_THROW(Drawing(10, 10, palette::white, 9), InputError);
    Drawing drawing(10, 10);
    EXPECT_THROW(drawing.line({0, 0}, nowhere, Stroke{}), InputError);
    EXPECT_THROW(drawing.polyline({{0, 0}, nowhere}, Stroke{black, 1, 4}), InputError);
    EXPECT_THROW(drawing.polygon({{0, 0}, {1, 1}, nowhere}, black), InputError);
    EXPECT_THROW(drawing.circle(nowhere, 1, black), InputError);
    EXPECT_THROW(drawing.circle({1, 1}, -1, black), InputError);
    EXPECT_THROW(drawing.line({0, 0}, {1, 1}, Stroke{black, 0}), InputError);
    EXPECT_THROW(drawing.line({0, 0}, {1, 1}, Stroke{black, 1, 0.001}), InputError) << "A million dashes?";
    EXPECT_THROW(drawing.text(nowhere, "x", {}), InputError);
    EXPECT_THROW(drawing.text({1, 1}, "x", {-3}), InputError);
    EXPECT_THROW(drawing.image(Image(1, 1), Bounds2()), InputError);
    EXPECT_THROW(drawing.save("a.jpg"), InputError);
    EXPECT_EQ(drawing.bgr(), Drawing(10, 10).bgr());
}

}  // namespace
}  // namespace caustic
