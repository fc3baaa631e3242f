#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "camera/box_filter.h"
#include "camera/pinhole_camera.h"
#include "integrator/adaptive.h"
#include "sampling/independent_sampler.h"

namespace caustic {
namespace {

constexpr int width = 10;
constexpr int height = 6;
constexpr std::size_t pixels = width * height;

std::size_t placeOf(Pixel pixel) { return static_cast<std::size_t>(pixel.y * width + pixel.x); }

// A method without a scene: a coloured value that goes with pixel and path.
class Synthetic final : public Integrator {
public:
    Synthetic(const Scene& scene, const Sampler& sampler, const PixelFilter& filter)
        : Integrator(scene, sampler, filter) {}
    Color Li(const Ray&, const MediumStack&, const PathNumbers&, RayCounts&) const override { return Color::Ones(); }
    Color tracePath(const PathId& path, std::vector<Splat>&, RayCounts& counts) const override {
        ++counts.rays;
        return value(path);
    }
    static Color value(const PathId& path) {
        return {1.0 + path.pixel.x, std::abs(std::sin(static_cast<Real>(7 * path.index + path.pixel.y))), 3};
    }
};

// Wants what it is told.
class Told final : public AdaptiveRule {
public:
    explicit Told(std::vector<Real> wants) : wants_(std::move(wants)) {}
    std::vector<Real> wanted(const PixelEstimates&) const override { return wants_; }

private:
    std::vector<Real> wants_;
};

std::vector<Real> wants(const std::map<std::size_t, Real>& some) {
    std::vector<Real> all(pixels, 0);
    for (const auto& [place, want] : some) all[place] = want;
    return all;
}

struct Case {
    Scene scene{{{}, {}, Color::Zero(), std::make_shared<PinholeCamera>(Vec3::Zero(), Vec3::UnitZ(), Vec3::UnitY(), 1, width, height)}};
    IndependentSampler sampler{1};
    BoxFilter filter;
    Synthetic inner{scene, sampler, filter};
    Told rule;
    AdaptiveIntegrator adaptive;

    Case(const std::map<std::size_t, Real>& some, const AdaptiveSettings& settings)
        : rule(wants(some)), adaptive(inner, sampler, rule, settings) {}

    // Runs a pass and says which paths it had.
    std::vector<PathId> pass() {
        std::vector<PathId> paths = adaptive.next();
        last = adaptive.runPass({number++, paths}, 1);
        return paths;
    }
    std::int64_t number = 0;
    Rendering last{Film(width, height), {}, 0, 0};
};

std::map<std::size_t, std::int64_t> countsOf(const std::vector<PathId>& paths) {
    std::map<std::size_t, std::int64_t> counts;
    for (const PathId& one : paths) ++counts[placeOf(one.pixel)];
    return counts;
}

// All pixels first, in batches; nobody asks the rule before.
TEST(AdaptiveLoop, GivesEachPixelTheFirstPaths) {
    Case one({{7, 1}}, {.batch = 4, .first = 10, .spread = 0});
    for (int pass = 0; pass < 3; ++pass) {
        const auto counts = countsOf(one.pass());
        ASSERT_EQ(counts.size(), pixels) << "pass " << pass << ": 10 paths are three batches of 4.";
        for (const auto& [place, count] : counts) ASSERT_EQ(count, 4);
    }
    EXPECT_EQ(countsOf(one.pass()), (std::map<std::size_t, std::int64_t>{{7, 4}})) << "Then the rule has its say.";
}

// The paths of a pixel are numbered through, and a pixel's stand together: no number twice, none left out.
TEST(AdaptiveLoop, NumbersPathsThrough) {
    Case one({{7, 1}, {23, 5}, {59, 2}}, {.batch = 3, .first = 3, .share = 0.04, .spread = 0});
    std::map<std::size_t, std::vector<std::int64_t>> indices;
    for (int pass = 0; pass < 9; ++pass) {
        std::set<std::size_t> ended;
        std::size_t current = pixels;
        for (const PathId& path : one.pass()) {
            const std::size_t place = placeOf(path.pixel);
            if (place != current) {
                ASSERT_TRUE(ended.insert(place).second) << "A pixel's paths stand together.";
            }
            current = place;
            indices[place].push_back(path.index);
        }
    }
    for (const auto& [place, own] : indices) {
        for (std::size_t i = 0; i < own.size(); ++i)
            ASSERT_EQ(own[i], static_cast<std::int64_t>(i)) << "pixel " << place << ": the same path again is no news.";
    }
}

// Of those that want paths, the share that wants them most; those that don't want any get none.
TEST(AdaptiveLoop, TakesThoseThatWantItMost) {
    const std::map<std::size_t, Real> some = {{3, 0.5}, {9, 7}, {17, 1e-3}, {31, 2}, {44, 7}, {58, 1e9}};
    Case one(some, {.batch = 2, .first = 2, .share = 0.05, .spread = 0});
    one.pass();
    const auto counts = countsOf(one.pass());
    EXPECT_EQ(counts, (std::map<std::size_t, std::int64_t>{{9, 2}, {44, 2}, {58, 2}})) << "3 of 60 pixels.";
    Case all(some, {.batch = 2, .first = 2, .share = 1, .spread = 0});
    all.pass();
    EXPECT_EQ(countsOf(all.pass()).size(), some.size()) << "Who wants 0 gets none, even if there is room.";
    Case none({}, {.batch = 2, .first = 2, .share = 1});
    none.pass();
    EXPECT_TRUE(none.adaptive.next().empty()) << "Nobody wants any: the end.";
}

// Around one that wants paths its neighbours get them, too, over no border of the picture.
TEST(AdaptiveLoop, SpreadsToNeighbours) {
    Case one({{10, 3}}, {.batch = 1, .first = 1, .share = 1, .spread = 1});
    one.pass();
    std::set<std::size_t> chosen;
    for (const auto& [place, count] : countsOf(one.pass())) chosen.insert(place);
    EXPECT_EQ(chosen, (std::set<std::size_t>{0, 1, 10, 11, 20, 21}));
}

// Limits: of a pixel, and of the picture.
TEST(AdaptiveLoop, KeepsItsLimits) {
    Case one({{7, 1}, {8, 9}}, {.batch = 4, .first = 8, .most = 17, .share = 1, .spread = 0});
    for (int pass = 0; pass < 9; ++pass) one.pass();
    EXPECT_EQ(one.adaptive.paths({7, 0}), 16) << "Another batch would be more than the most.";
    EXPECT_TRUE(one.adaptive.next().empty());
    Case whole({{7, 1}, {8, 9}, {9, 4}}, {.batch = 2, .first = 2, .paths = 2 * pixels + 5, .share = 1, .spread = 0});
    while (!whole.adaptive.next().empty()) whole.pass();
    EXPECT_EQ(whole.adaptive.paths(), static_cast<std::int64_t>(2 * pixels + 4));
    EXPECT_EQ(whole.adaptive.paths({8, 0}), 4) << "Paths that are left go to who wants them most.";
    EXPECT_EQ(whole.adaptive.paths({7, 0}), 2);
}

// Each batch is entered once, as the mean of its paths; the film has all of them.
TEST(AdaptivePass, EntersTheMeanOfEachBatch) {
    Case one({{12, 1}}, {.batch = 3, .first = 6, .share = 1, .spread = 0});
    Film film(width, height);
    for (int pass = 0; pass < 4; ++pass) {
        one.pass();
        film.merge(one.last.film);
    }
    for (const Pixel pixel : {Pixel{2, 1}, Pixel{3, 4}}) {
        const std::int64_t paths = pixel == Pixel{2, 1} ? 12 : 6;
        PixelEstimate expected;
        for (std::int64_t first = 0; first < paths; first += 3) {
            Color sum = Color::Zero();
            for (std::int64_t i = first; i < first + 3; ++i) sum += Synthetic::value({pixel, i});
            expected.add(sum / 3);
        }
        const PixelEstimate& found = one.adaptive.estimates()[placeOf(pixel)];
        EXPECT_EQ(found.batches, expected.batches) << "Once for each batch, not for each path.";
        EXPECT_LE((found.mean - expected.mean).abs().maxCoeff(), 1e-12);
        EXPECT_LE((found.squares - expected.squares).abs().maxCoeff(), 1e-12);
        EXPECT_EQ(one.adaptive.paths(pixel), paths);
        EXPECT_EQ(film.samples(pixel), paths);
        EXPECT_LE((film.value(pixel) - expected.mean).abs().maxCoeff(), 1e-12);
    }
    EXPECT_EQ(one.last.counts.rays, 3) << "What the method has done in the scene is told.";
}

// Apart: every other pass decides and isn't shown; what is shown decides nothing.
TEST(AdaptivePass, DecidesApartFromWhatCounts) {
    Case one({{12, 1}}, {.batch = 2, .first = 4, .share = 1, .spread = 0, .apart = true});
    const Pixel pixel = {2, 1};
    std::int64_t shown = 0;
    for (int pass = 0; pass < 6; ++pass) {
        const std::int64_t before = one.adaptive.estimates()[placeOf(pixel)].batches;
        one.pass();
        const bool decides = pass % 2 == 0;
        EXPECT_EQ(one.adaptive.estimates()[placeOf(pixel)].batches - before, decides ? 1 : 0) << "pass " << pass;
        EXPECT_EQ(one.last.film.samples(pixel), decides ? 0 : 2) << "pass " << pass;
        EXPECT_EQ(one.last.counts.rays > 0, true) << "It costs, shown or not.";
        shown += one.last.film.samples(pixel);
    }
    EXPECT_EQ(shown, 6);
    EXPECT_EQ(one.adaptive.paths(pixel), 12) << "All paths are numbered, shown or not.";
}

}  // namespace
}  // namespace caustic
