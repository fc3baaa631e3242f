#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "camera/box_filter.h"
#include "core/error.h"
#include "failures/synthetic.h"
#include "importance.h"
#include "integrator/adaptive.h"
#include "integrator/checkpoint.h"
#include "integrator/path_tracer.h"
#include "integrator/sppm.h"
#include "measures/lit_floor.h"
#include "modeler/peers_box.h"
#include "sampling/independent_sampler.h"
#include "scenes.h"

namespace caustic {
namespace {

// Student's t for 97.5 %: the tables' values.
TEST(StudentT, IsThatOfTheTables) {
    struct Row {
        std::int64_t degrees;
        Real t;
        Real tolerance;
    };
    for (const Row& row : {Row{2, 4.30265, 0.08}, Row{3, 3.18245, 0.01}, Row{5, 2.57058, 1e-3}, Row{15, 2.13145, 1e-4},
                           Row{100, 1.98397, 1e-5}, Row{100'000'000, 1.959964, 1e-6}})
        EXPECT_NEAR(studentT(1.959964, row.degrees), row.t, row.tolerance) << row.degrees << " degrees";
    EXPECT_LT(studentT(1.959964, 1), 12.7063);
}

Rendering adaptively(Integrator& inner, const Sampler& sampler, const AdaptiveRule& rule,
                     const AdaptiveSettings& settings, int threads) {
    AdaptiveIntegrator adaptive(inner, sampler, rule, settings);
    return renderAdaptively(adaptive, {.threads = threads});
}

// The same bits for one thread and two, by path tracing and by SPPM.
TEST(Adaptive, IsTheSameForAnyThreads) {
    const Scene scene(peersBox(20, 20));
    const IndependentSampler sampler(5);
    const BoxFilter filter;
    const IntervalRule rule(0.05);
    const AdaptiveSettings settings = {.batch = 2, .first = 4, .paths = 20 * 20 * 12, .share = 0.2};
    PathTracer tracer(scene, sampler, filter, {{8, 1}, Direct::Mis});
    SppmSettings photons;
    photons.photons = 500;
    const auto same = [](const Rendering& one, const Rendering& other) {
        EXPECT_EQ(one.passes, other.passes);
        for (int y = 0; y < 20; ++y) {
            for (int x = 0; x < 20; ++x) {
                ASSERT_TRUE((one.film.value({x, y}) == other.film.value({x, y})).all());
                ASSERT_EQ(one.film.samples({x, y}), other.film.samples({x, y}));
            }
        }
    };
    same(adaptively(tracer, sampler, rule, settings, 1), adaptively(tracer, sampler, rule, settings, 2));
    Sppm one(scene, sampler, filter, photons);
    Sppm two(scene, sampler, filter, photons);
    same(adaptively(one, sampler, rule, settings, 1), adaptively(two, sampler, rule, settings, 2));
}

// Stopped, written, read by another process's objects, and gone on with: the same bits as without the stop. What is
// damaged is refused.
TEST(Adaptive, GoesOnFromACheckpoint) {
    const Scene scene(peersBox(16, 16));
    const IndependentSampler sampler(6);
    const BoxFilter filter;
    const GainRule rule;
    const AdaptiveSettings settings = {.batch = 2, .first = 4, .paths = 16 * 16 * 14, .share = 0.15, .apart = true};
    PathTracer tracer(scene, sampler, filter, {{8, 1}, Direct::Mis});
    AdaptiveIntegrator whole(tracer, sampler, rule, settings);
    const Rendering expected = renderAdaptively(whole, {});
    AdaptiveIntegrator first(tracer, sampler, rule, settings);
    Rendering rendering = renderAdaptively(first, {.passes = 7});
    std::stringstream file;
    ByteWriter to(file);
    first.save(to);
    AdaptiveIntegrator second(tracer, sampler, rule, settings);
    ByteReader from(file, "state");
    second.load(from);
    resume(second, {.choose = [&](const Rendering&) { return second.next(); }}, rendering);
    ASSERT_EQ(rendering.passes, expected.passes);
    for (int y = 0; y < 16; ++y) {
        for (int x = 0; x < 16; ++x) ASSERT_TRUE((rendering.film.value({x, y}) == expected.film.value({x, y})).all());
    }
    std::stringstream cut(file.str().substr(0, 100));
    ByteReader fromCut(cut, "state");
    EXPECT_THROW(second.load(fromCut), InputError);
    std::string bytes = file.str();
    for (std::size_t i = 0; i < 8; ++i) bytes[i] = '\xff';
    std::stringstream negative(bytes);
    ByteReader fromNegative(negative, "state");
    EXPECT_THROW(second.load(fromNegative), InputError);
}

// Each rule on a picture of one noisy half: the noisy half gets the paths.
TEST(AdaptiveRules, SendPathsWhereTheNoiseIs) {
    const Scene scene = emptyPicture(24, 12);
    const IndependentSampler sampler(8);
    const BoxFilter filter;
    const EdgeRule edge(0.1);
    const IntervalRule interval(0.02);
    const GainRule gain;
    const AdaptiveRule* const rules[] = {&edge, &interval, &gain};
    for (const AdaptiveRule* const rule : rules) {
        SyntheticIntegrator inner(scene, sampler, filter,
                                  [](const Vec2& film, Real number) { return film.x() < 12 ? 0.5 : number; });
        AdaptiveIntegrator adaptive(inner, sampler, *rule,
                                    {.batch = 2, .first = 4, .paths = 24 * 12 * 20, .share = 0.1});
        renderAdaptively(adaptive, {});
        std::int64_t quiet = 0;
        std::int64_t noisy = 0;
        for (int y = 0; y < 12; ++y) {
            for (int x = 0; x < 10; ++x) quiet += adaptive.paths({x, y});
            for (int x = 14; x < 24; ++x) noisy += adaptive.paths({x, y});
        }
        EXPECT_EQ(quiet, 10 * 12 * 4);
        EXPECT_GT(noisy, 4 * quiet);
    }
}

// Known noise: deviations 1 and 4 in equal halves. By the largest gain paths go as the deviation does (Neyman 1934), so
// the halves get them as 1 : 4; the widest interval gives them as the variance, 1 : 16.
TEST(AdaptiveRules, SharePathsAsTheirTheoryHasIt) {
    const Scene scene = emptyPicture(20, 20);
    const IndependentSampler sampler(9);
    const BoxFilter filter;
    const GainRule gain;
    const IntervalRule interval(1e-9);
    const auto shares = [&](const AdaptiveRule& rule) {
        SyntheticIntegrator inner(scene, sampler, filter, [](const Vec2& film, Real number) {
            return 1000 + (film.x() < 10 ? 1 : 4) * std::sqrt(12.0) * (number - 0.5);
        });
        AdaptiveIntegrator adaptive(inner, sampler, rule,
                                    {.batch = 2, .first = 32, .paths = 400 * 600, .share = 0.02, .spread = 0});
        renderAdaptively(adaptive, {});
        Real left = 0;
        Real right = 0;
        for (int y = 0; y < 20; ++y) {
            for (int x = 0; x < 10; ++x) left += static_cast<Real>(adaptive.paths({x, y}));
            for (int x = 10; x < 20; ++x) right += static_cast<Real>(adaptive.paths({x, y}));
        }
        return right / left;
    };
    EXPECT_NEAR(shares(gain), 4, 0.4);
    EXPECT_NEAR(shares(interval), 16, 3);
}

Real totalOf(const Image& picture) {
    Real sum = 0;
    for (const float value : picture.data()) sum += Real{value};
    return sum;
}

// Deciding apart, the mean is right where stopping on one's own values makes it too dark: 1 with a chance of a fifth
// each time, in 1024 pixels.
TEST(Adaptive, ApartTheMeanIsRight) {
    const Scene scene = emptyPicture(32, 32);
    const BoxFilter filter;
    const IntervalRule rule(0.2);
    Real apart = 0;
    Real own = 0;
    constexpr int pictures = 8;
    for (std::uint64_t seed = 0; seed < pictures; ++seed) {
        const IndependentSampler sampler(100 + seed);
        SyntheticIntegrator inner(scene, sampler, filter,
                                  [](const Vec2&, Real number) { return number < 0.2 ? 5 : 0; });
        const auto mean = [&](const AdaptiveSettings& settings) {
            const Image picture = adaptively(inner, sampler, rule, settings, 1).film.image();
            return totalOf(picture) / (3 * 1024.0 * pictures);
        };
        apart += mean({.batch = 2, .first = 8, .most = 200, .share = 1, .spread = 0, .apart = true});
        own += mean({.batch = 2, .first = 8, .most = 200, .share = 1, .spread = 0});
    }
    // At least 4 counted paths in each of 8192 pixels: standard error 2/√(4 · 8192) = 1.1 %; as measured half of it.
    EXPECT_NEAR(apart, 1, 0.055);
    EXPECT_LT(own, 0.93) << "This is what is cured.";
}

// All four densities have the same mean: the closed form.
TEST(Importance, EachDensityFindsTheSameLight) {
    const LitFloor floor = LitFloor::beside(6);
    const Image truth = floor.truth();
    const IndependentSampler sampler(11);
    const BoxFilter filter;
    for (const Importance density : {Importance::Uniform, Importance::Cosine, Importance::Lamp, Importance::Both}) {
        ImportanceTracer tracer(floor.scene(), sampler, filter, density);
        const Image picture = render(tracer, {.passes = 20'000}).film.image();
        EXPECT_NEAR(totalOf(picture) / totalOf(truth), 1, 0.02) << nameOf(density);
    }
}

TEST(Adaptive, RefusesSettingsByName) {
    const Scene scene = emptyPicture(4, 4);
    const IndependentSampler sampler(1);
    const BoxFilter filter;
    SyntheticIntegrator inner(scene, sampler, filter, [](const Vec2&, Real) { return 1; });
    const GainRule rule;
    const auto refused = [&](const AdaptiveSettings& settings, const std::string& name) {
        try {
            AdaptiveIntegrator adaptive(inner, sampler, rule, settings);
            ADD_FAILURE() << name;
        } catch (const InputError& error) {
            EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << error.what();
        }
    };
    refused({.batch = 0}, "batch");
    refused({.first = 0}, "first");
    refused({.first = 16, .most = 15}, "most");
    refused({.paths = 0}, "in all");
    refused({.share = 0}, "share");
    refused({.share = 1.5}, "share");
    refused({.share = std::nan("")}, "share");
    refused({.spread = -1}, "spread");
    for (const Real bad : {0.0, -1.0, 5.0, std::nan(""), HUGE_VAL}) EXPECT_THROW(EdgeRule{bad}, InputError);
    for (const Real bad : {0.0, -1.0, std::nan(""), HUGE_VAL}) {
        EXPECT_THROW(IntervalRule{bad}, InputError);
        EXPECT_THROW(IntervalRule(0.1, bad), InputError);
    }
    EXPECT_THROW(study("teapot"), InputError);
}

}  // namespace
}  // namespace caustic
