#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <span>
#include <sstream>

#include "camera/box_filter.h"
#include "camera/pinhole_camera.h"
#include "integrator/adaptive.h"
#include "sampling/independent_sampler.h"

namespace caustic {
namespace {

constexpr int width = 10;
constexpr int height = 6;
constexpr std::size_t pixels = width * height;

constexpr Pixel broken = {9, 5};  // brings no numbers

std::size_t placeOf(Pixel pixel) { return static_cast<std::size_t>(pixel.y * width + pixel.x); }

// A method without a scene: a coloured value that goes with pixel and path.
class Synthetic final : public Integrator {
public:
    Synthetic(const Scene& scene, const Sampler& sampler, const PixelFilter& filter)
        : Integrator(scene, sampler, filter) {}
    Color Li(const Ray&, const MediumStack&, const PathNumbers&, RayCounts&) const override { return Color::Ones(); }
    Color tracePath(const PathId& path, std::vector<Splat>&, RayCounts& counts) const override {
        ++counts.rays;
        if (path.pixel == broken) return Color::Constant(std::numeric_limits<Real>::quiet_NaN());
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
    Scene scene{{{},
                 {},
                 Color::Zero(),
                 std::make_shared<PinholeCamera>(Vec3::Zero(), Vec3::UnitZ(), Vec3::UnitY(), 1, width, height)}};
    IndependentSampler sampler{1};
    BoxFilter filter;
    Synthetic inner{scene, sampler, filter};
    Told rule;
    AdaptiveIntegrator adaptive;

    Case(const std::map<std::size_t, Real>& some, const AdaptiveSettings& settings)
        : rule(wants(some)), adaptive(inner, sampler, rule, settings) {}

    // As if each pixel had had so many paths, in a batch each.
    void start(const std::vector<std::int64_t>& given) {
        std::stringstream file;
        ByteWriter to(file);
        for (const std::int64_t count : given) {
            to.put(std::array{count, count});
            to.put(std::array<Real, 6>{1, 2, 3, 1, 1, 1});
        }
        ByteReader from(file, "a test");
        adaptive.load(from);
    }
    void start(std::int64_t given) { start(std::vector<std::int64_t>(pixels, given)); }
};

std::map<std::size_t, std::int64_t> countsOf(const std::vector<PathId>& paths) {
    std::map<std::size_t, std::int64_t> counts;
    for (const PathId& one : paths) ++counts[placeOf(one.pixel)];
    return counts;
}

// All pixels first, in batches; nobody asks the rule before.
TEST(AdaptiveLoop, GivesEachPixelTheFirstPaths) {
    Case one({{7, 1}}, {.batch = 4, .first = 10, .spread = 0});
    for (const std::int64_t given : {0, 4, 8}) {
        one.start(given);
        const auto counts = countsOf(one.adaptive.next());
        ASSERT_EQ(counts.size(), pixels) << given << " so far: 10 paths are three batches of 4.";
        for (const auto& [place, count] : counts) ASSERT_EQ(count, 4);
    }
    one.start(12);
    EXPECT_EQ(countsOf(one.adaptive.next()), (std::map<std::size_t, std::int64_t>{{7, 4}}))
        << "Then the rule has its say.";
    std::vector<std::int64_t> given(pixels, 12);
    given[0] = 8;
    given[31] = 0;
    given[59] = 9;
    one.start(given);
    EXPECT_EQ(countsOf(one.adaptive.next()), (std::map<std::size_t, std::int64_t>{{0, 4}, {31, 4}, {59, 4}}))
        << "Those that have their first paths wait for the others.";
    Case whole({{7, 1}}, {.batch = 5, .first = 10, .spread = 0});
    given.assign(pixels, 10);
    given[31] = 5;
    whole.start(given);
    EXPECT_EQ(countsOf(whole.adaptive.next()), (std::map<std::size_t, std::int64_t>{{31, 5}}))
        << "10 paths are all of the first 10: does such a pixel wait for the others?";
    Case few({{7, 1}}, {.batch = 4, .first = 10, .paths = 12 * pixels, .spread = 0});
    given.assign(pixels, 12);
    given[0] = 8;
    given[1] = 5;
    given[2] = 1;
    few.start(given);
    EXPECT_EQ(few.adaptive.next().size(), 12U) << "22 paths are left, and three pixels want their first ones.";
    given[59] = 24;
    few.start(given);
    EXPECT_EQ(few.adaptive.next().size(), 8U) << "Ten paths are left: two batches.";
}

// The paths of a pixel are numbered through, and a pixel's stand together: no number twice, none left out.
TEST(AdaptiveLoop, NumbersPathsThrough) {
    Case one({{7, 1}, {23, 5}, {59, 2}}, {.batch = 3, .first = 3, .share = 1, .spread = 0});
    std::vector<std::int64_t> given(pixels, 3);
    given[7] = 12;
    given[59] = 30;
    one.start(given);
    std::map<std::size_t, std::vector<std::int64_t>> indices;
    std::size_t before = pixels;
    for (const PathId& path : one.adaptive.next()) {
        const std::size_t place = placeOf(path.pixel);
        if (place != before) {
            ASSERT_EQ(indices.count(place), 0U) << "A pixel's paths stand together.";
        }
        before = place;
        indices[place].push_back(path.index);
    }
    EXPECT_EQ(indices[7], (std::vector<std::int64_t>{12, 13, 14})) << "The same path again is no news.";
    EXPECT_EQ(indices[23], (std::vector<std::int64_t>{3, 4, 5}));
    EXPECT_EQ(indices[59], (std::vector<std::int64_t>{30, 31, 32}));
}

// Of those that want paths, the share that wants them most; those that don't want any get none.
TEST(AdaptiveLoop, TakesThoseThatWantItMost) {
    const std::map<std::size_t, Real> some = {{3, 0.5}, {9, 7}, {17, 1e-3}, {31, 2}, {44, 7}, {58, 1e9}};
    Case one(some, {.batch = 2, .first = 2, .share = 0.05, .spread = 0});
    one.start(2);
    EXPECT_EQ(countsOf(one.adaptive.next()), (std::map<std::size_t, std::int64_t>{{9, 2}, {44, 2}, {58, 2}}))
        << "3 of 60 pixels.";
    Case rounded(some, {.batch = 2, .first = 2, .share = 0.021, .spread = 0});
    rounded.start(2);
    EXPECT_EQ(rounded.adaptive.next().size(), 4U) << "A share of 1.26 pixels: two.";
    Case whole(some, {.batch = 2, .first = 2, .share = 1, .spread = 0});
    whole.start(2);
    EXPECT_EQ(countsOf(whole.adaptive.next()).size(), some.size())
        << "A pixel that wants 0 gets none, even if there is room.";
    Case none({}, {.batch = 2, .first = 2, .share = 1});
    none.start(2);
    EXPECT_TRUE(none.adaptive.next().empty()) << "Nobody wants any: the end.";
}

// Around one that wants paths its neighbours get them, too, over no border of the picture.
TEST(AdaptiveLoop, SpreadsToNeighbours) {
    Case one({{10, 3}}, {.batch = 1, .first = 1, .share = 1, .spread = 1});
    one.start(1);
    std::set<std::size_t> chosen;
    for (const auto& [place, count] : countsOf(one.adaptive.next())) chosen.insert(place);
    EXPECT_EQ(chosen, (std::set<std::size_t>{0, 1, 10, 11, 20, 21}));
}

// Limits: of a pixel, and of the picture.
TEST(AdaptiveLoop, KeepsItsLimits) {
    Case one({{7, 1}, {8, 9}}, {.batch = 4, .first = 8, .most = 17, .share = 1, .spread = 0});
    std::vector<std::int64_t> given(pixels, 8);
    given[7] = 16;
    given[8] = 13;
    one.start(given);
    EXPECT_EQ(countsOf(one.adaptive.next()), (std::map<std::size_t, std::int64_t>{{8, 4}}))
        << "Another batch would be more than the most; or just the most.";
    Case whole({{7, 1}, {8, 9}, {9, 4}}, {.batch = 2, .first = 2, .paths = 2 * pixels + 5, .share = 1, .spread = 0});
    whole.start(2);
    EXPECT_EQ(whole.adaptive.next().size(), 4U) << "Five paths are left: two batches.";
    Case spent({{7, 1}}, {.batch = 1, .first = 1, .paths = 2 * pixels - 3, .share = 1, .spread = 0});
    spent.start(2);
    EXPECT_TRUE(spent.adaptive.next().empty()) << "More have been taken than there are.";
}

std::vector<PathId> pathsOf(const std::vector<Pixel>& some, std::int64_t first, int batch) {
    std::vector<PathId> paths;
    for (const Pixel pixel : some) {
        for (int k = 0; k < batch; ++k) paths.push_back({pixel, first + k});
    }
    return paths;
}

// Each batch is entered as the mean of its paths; the film has all of them.
TEST(AdaptivePass, EntersTheMeanOfEachBatch) {
    Case one({}, {.batch = 3});
    Film film(width, height);
    const std::vector<Pixel> some = {{2, 1}, {3, 1}, {3, 4}};
    RayCounts counts;
    for (std::int64_t pass = 0; pass < 4; ++pass) {
        const auto paths = pathsOf(some, 3 * pass, 3);
        const Rendering rendering = one.adaptive.runPass({pass, paths}, 1);
        film.merge(rendering.film);
        counts += rendering.counts;
    }
    for (const Pixel pixel : some) {
        PixelEstimate expected;
        for (std::int64_t first = 0; first < 12; first += 3) {
            Color sum = Color::Zero();
            for (std::int64_t i = first; i < first + 3; ++i) sum += Synthetic::value({pixel, i});
            expected.add(sum / 3);
        }
        const PixelEstimate& found = one.adaptive.estimates()[placeOf(pixel)];
        EXPECT_EQ(found.batches, 4) << "Once for each batch, not for each path.";
        EXPECT_LE((found.mean - expected.mean).abs().maxCoeff(), 1e-12) << "The mean of the batch, not its sum?";
        EXPECT_LE((found.squares - expected.squares).abs().maxCoeff(), 1e-12);
        EXPECT_EQ(film.samples(pixel), 12);
        EXPECT_LE((film.value(pixel) - expected.mean).abs().maxCoeff(), 1e-12);
    }
    EXPECT_EQ(one.adaptive.estimates()[0].batches, 0) << "A pixel without paths learns nothing.";
    EXPECT_EQ(counts.rays, 36) << "What the method has done in the scene is told.";

    // A pass is a part of a longer list, as several machines share it: what stands behind it isn't in it.
    const std::vector<PathId> list = pathsOf({{2, 1}, {5, 3}}, 0, 4);
    for (const std::size_t size : {3, 4}) {
        Case part({}, {.batch = 3});
        part.adaptive.runPass({0, std::span(list).first(size)}, 1);
        EXPECT_EQ(part.adaptive.paths(), static_cast<std::int64_t>(size)) << "How many paths has the pass?";
        EXPECT_EQ(part.adaptive.paths({2, 1}), static_cast<std::int64_t>(size)) << "How many paths has the pass?";
        EXPECT_EQ(part.adaptive.estimates()[placeOf({2, 1})].batches, 1) << "Does the last batch of a pass count?";
        EXPECT_EQ(part.adaptive.estimates()[placeOf({5, 3})].batches, 0) << "Where does the pass end?";
    }

    // A batch may be a single path. One without any number is no batch: it isn't black.
    Case single({}, {.batch = 1});
    const std::vector<Pixel> two = {{2, 1}, broken};
    for (std::int64_t pass = 0; pass < 3; ++pass) {
        const auto paths = pathsOf(two, pass, 1);
        single.adaptive.runPass({pass, paths}, 1);
    }
    EXPECT_EQ(single.adaptive.estimates()[placeOf({2, 1})].batches, 3) << "A batch of one path is a batch.";
    EXPECT_EQ(single.adaptive.estimates()[placeOf(broken)].batches, 0)
        << "What is known of a pixel whose paths brought no numbers?";
    EXPECT_EQ(single.adaptive.paths(broken), 3) << "They are numbered all the same.";
}

// Apart: every other pass decides and isn't shown; what is shown decides nothing.
TEST(AdaptivePass, DecidesApartFromWhatCounts) {
    Case one({}, {.batch = 2, .apart = true});
    const Pixel pixel = {2, 1};
    for (std::int64_t pass = 0; pass < 6; ++pass) {
        const std::int64_t before = one.adaptive.estimates()[placeOf(pixel)].batches;
        const auto paths = pathsOf({pixel}, 2 * pass, 2);
        const Rendering rendering = one.adaptive.runPass({pass, paths}, 1);
        const bool decides = pass % 2 == 0;
        EXPECT_EQ(one.adaptive.estimates()[placeOf(pixel)].batches - before, decides ? 1 : 0) << "pass " << pass;
        ASSERT_EQ(rendering.film.width(), width) << "Is an empty film as large as a full one?";
        ASSERT_EQ(rendering.film.height(), height) << "Is an empty film as large as a full one?";
        EXPECT_EQ(rendering.film.samples(pixel), decides ? 0 : 2) << "pass " << pass;
        EXPECT_EQ(rendering.counts.rays, 2) << "It costs, shown or not.";
    }
    EXPECT_EQ(one.adaptive.paths(pixel), 12) << "All paths are numbered, shown or not.";
}

}  // namespace
}  // namespace caustic
