#include <gtest/gtest.h>

#include "camera/box_filter.h"
#include "integrator/path_tracer.h"
#include "sampling/independent_sampler.h"

namespace caustic {
namespace {

const IndependentSampler sampler(1);
const BoxFilter box;

const Scene& anyScene() {
    static const Scene scene(SceneDescription{});
    return scene;
}

// Where both ways lead to a light, each counts by the power heuristic, and the two weights sum to 1 (Veach, eq. 9.13).
TEST(LightWeight, IsThePowerHeuristicOfBothWays) {
    const PathTracer tracer(anyScene(), sampler, box, {.direct = Direct::Mis});
    for (const Real asked : {1e-9, 0.02, 1.0, 7.0, 1e12}) {
        for (const Real chance : {1e-12, 0.01, 0.3, 20.0, 1e9}) {
            const Real all = asked * asked + chance * chance;
            EXPECT_NEAR(tracer.weight(PathTracer::Sampled::Light, asked, chance), asked * asked / all, 1e-12)
                << "Whose density stands above?";
            EXPECT_NEAR(tracer.weight(PathTracer::Sampled::Direction, asked, chance), chance * chance / all, 1e-12)
                << "Whose density stands above?";
        }
    }
}

// Where only one way leads to a light it counts in full: nobody asks at the eye and behind a mirror, and no path hits a
// point. Where always somebody asks, what is met by chance must not count again.
TEST(LightWeight, CountsEverythingOnce) {
    using Sampled = PathTracer::Sampled;
    const PathTracer chance(anyScene(), sampler, box, {.direct = Direct::ByChance});
    const PathTracer asking(anyScene(), sampler, box, {.direct = Direct::DirectLight});
    const PathTracer both(anyScene(), sampler, box, {.direct = Direct::Mis});
    for (const PathTracer* const one : {&chance, &asking, &both})
        EXPECT_EQ(one->weight(Sampled::Direction, 0, 0.7), 1) << "Does anybody ask behind a mirror?";
    for (const PathTracer* const one : {&asking, &both})
        EXPECT_EQ(one->weight(Sampled::Light, 0.7, 0), 1) << "Does any path hit a light at a point?";
    EXPECT_EQ(chance.weight(Sampled::Direction, 2, 0.7), 1) << "With this setting nobody asks.";
    for (const Real density : {0.0, 0.7})
        EXPECT_EQ(chance.weight(Sampled::Light, 2, density), 0)
            << "With this setting nobody asks: is that light there twice?";
    EXPECT_EQ(asking.weight(Sampled::Light, 2, 0.7), 1) << "With this setting somebody always asks.";
    for (const Real density : {1e-12, 2.0, 1e12})
        EXPECT_EQ(asking.weight(Sampled::Direction, density, 0.7), 0) << "Is this light counted twice?";
}

}  // namespace
}  // namespace caustic
