#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

#include "camera/box_filter.h"
#include "core/error.h"
#include "image/picture_error.h"
#include "integrator/lamp_edges.h"
#include "integrator/render.h"
#include "integrator/sppm.h"
#include "modeler/peers_box.h"
#include "sampling/sobol_sampler.h"

namespace caustic {
namespace {

constexpr int width = 48;
const SppmSettings settings = {.limits = {.maxLength = 10}, .photons = 2000};

Color meanOf(const Image& image) {
    Color sum = Color::Zero();
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) sum += image.at(x, y);
    }
    return sum / image.width() / image.height();
}

Scene box() { return Scene(peersBox(width, width)); }

// What is seen straight: a lamp's edge is where a pixel's corners disagree, and a pixel all around sees nothing of it.
TEST(LampEdges, HoldWhereAPixelsCornersDisagree) {
    const Scene scene = box();
    const std::vector<Pixel> edges = lampEdges(scene, SobolSampler(3), settings.limits, 2);
    std::set<std::pair<int, int>> found;
    for (const Pixel& pixel : edges) found.insert({pixel.x, pixel.y});
    ASSERT_EQ(found.size(), edges.size()) << "Each pixel once.";
    const auto lit = [&](int x, int y) {
        RayCounts counts;
        Color passed;
        MediumStack media = scene.cameraMedia();
        const Ray ray = scene.camera().sampleRay({x, y}, {0.5, 0.5});
        const auto at = scene.follow(ray, media, passed, counts);
        return at && at->light() != nullptr && (at->Le() > 0).any();
    };
    int borders = 0;
    for (int y = 0; y < width; ++y) {
        for (int x = 0; x < width; ++x) {
            const int corners = lit(x, y) + lit(x + 1, y) + lit(x, y + 1) + lit(x + 1, y + 1);
            if (corners == 0 || corners == 4) continue;
            ++borders;
            EXPECT_TRUE(found.contains({x, y})) << "pixel " << x << ", " << y;
        }
    }
    EXPECT_GT(borders, 10);
    EXPECT_LT(found.size(), width * width / 5) << "A few pixels, not all.";
    // The mirror ball, left below, shows the lamp, too.
    EXPECT_TRUE(std::any_of(edges.begin(), edges.end(), [](const Pixel& p) { return p.y > width / 2; }));
}

TEST(LampEdges, AreTheSameForAnyNumberOfThreads) {
    const Scene scene = box();
    const SobolSampler sampler(3);
    EXPECT_EQ(lampEdges(scene, sampler, settings.limits, 1), lampEdges(scene, sampler, settings.limits, 2));
}

// Three who share the search find what one finds; who begins below the picture finds nothing.
TEST(LampEdges, AreTheSameWhoeverLooksAtWhichRow) {
    const Scene scene = box();
    const SobolSampler sampler(3);
    constexpr int shares = 3;
    std::vector<std::uint8_t> all(static_cast<std::size_t>(width * width), 0);
    for (int share = 0; share < shares; ++share) {
        const auto own = edgesOfRows(scene, sampler, settings.limits, share, shares, 1);
        ASSERT_EQ(own.size(), all.size());
        for (std::size_t i = 0; i < all.size(); ++i) {
            EXPECT_FALSE(own[i] != 0 && static_cast<int>(i) / width % shares != share) << "a row of another share";
            all[i] |= own[i];
        }
    }
    EXPECT_EQ(withNeighbours(scene.camera(), all), lampEdges(scene, sampler, settings.limits, 1));
    const auto none = edgesOfRows(scene, sampler, settings.limits, width, shares, 1);
    EXPECT_EQ(none, std::vector<std::uint8_t>(all.size(), 0));
}

// Each pixel's paths are numbered without a gap, and no path comes twice.
TEST(WithMorePaths, NumbersThePathsOfAPixelOn) {
    const Scene scene = box();
    const std::vector<Pixel> several = {{3, 5}, {47, 0}};
    const auto choose = withMorePaths(scene.camera(), several, 7);
    std::vector<std::vector<std::int64_t>> indices(width * width);
    Rendering rendering = {Film(width, width), {}};
    for (rendering.passes = 0; rendering.passes < 3; ++rendering.passes) {
        for (const PathId& path : choose(rendering))
            indices[static_cast<std::size_t>(path.pixel.y * width + path.pixel.x)].push_back(path.index);
    }
    for (int y = 0; y < width; ++y) {
        for (int x = 0; x < width; ++x) {
            std::vector<std::int64_t>& own = indices[static_cast<std::size_t>(y * width + x)];
            std::sort(own.begin(), own.end());
            const bool more = std::find(several.begin(), several.end(), Pixel{x, y}) != several.end();
            ASSERT_EQ(own.size(), more ? 21U : 3U) << "pixel " << x << ", " << y;
            for (std::size_t i = 0; i < own.size(); ++i) ASSERT_EQ(own[i], static_cast<std::int64_t>(i));
        }
    }
    EXPECT_THROW(withMorePaths(scene.camera(), several, 0), InputError);
}

// Both pictures are of the same light: their means agree, and the one with more paths at the edges is nearer to a long
// rendering. Four renderings of each, and the worst of one kind is better than the best of the other.
TEST(WithMorePaths, LessensTheErrorAndNothingElse) {
    const Scene scene = box();
    const BoxFilter filter;
    const auto picture = [&](std::uint64_t seed, std::int64_t passes, int paths) {
        const SobolSampler sampler(seed);
        Sppm sppm(scene, sampler, filter, settings);
        const auto edges = lampEdges(scene, sampler, settings.limits, 1);
        const auto choose = withMorePaths(scene.camera(), edges, paths);
        return render(sppm, {.passes = passes, .threads = 2, .choose = choose}).film.image();
    };
    const Image reference = picture(99, 150, pathsAtLampEdges);
    Real worstOfMany = 0;
    Real bestOfOne = 1e9;
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        worstOfMany = std::max(worstOfMany, rmse(picture(seed, 8, pathsAtLampEdges), reference, {}));
        bestOfOne = std::min(bestOfOne, rmse(picture(seed, 8, 1), reference, {}));
    }
    EXPECT_LT(worstOfMany, bestOfOne);
    const Color with = meanOf(reference);
    const Color without = meanOf(picture(98, 150, 1));
    EXPECT_LE((with / without - 1).abs().maxCoeff(), 0.01);
}

}  // namespace
}  // namespace caustic
