#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "integrator/photon_tracer.h"
#include "light/point_light.h"
#include "material/diffuse_material.h"
#include "sampling/independent_sampler.h"
#include "shape/box.h"

namespace caustic {
namespace {

const IndependentSampler sampler(5);

// Lopsided, far from the origin, and lit from a corner.
SceneDescription closedBox() {
    return {{{std::make_shared<Box>(Vec3(5, -3, 2), Vec3(7.3, -2, 3.4)),
              std::make_shared<DiffuseMaterial>(Color(0.6, 0.3, 0.45)),
              {},
              nullptr}},
            {std::make_shared<PointLight>(Vec3(5.4, -2.3, 3.1), Color(4, 0.7, 2))},
            Color::Zero(),
            nullptr};
}

bool same(const std::vector<Photon>& a, const std::vector<Photon>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Photon& one, const Photon& other) {
        return one.point == other.point && one.wi == other.wi && (one.power == other.power).all();
    });
}

// Photons, their order and what they cost are the same for any number of threads.
TEST(TracePhotons, GivesTheSameForAnyThreads) {
    const Scene scene(closedBox());
    const LightChoice lights(scene.lights());
    for (const std::int64_t count : {1, 1023, 1024, 1025, 5000}) {
        RayCounts counts;
        const auto photons = tracePhotons(scene, lights, sampler, {}, 0, count, 1, counts);
        EXPECT_EQ(std::count_if(photons.begin(), photons.end(), [](const Photon& p) { return p.length == 1; }), count)
            << "Do as many set out as were asked for?";
        EXPECT_GE(counts.rays, count) << "Is what the batches asked of the scene counted?";
        for (const int threads : {2, 7}) {
            RayCounts own;
            EXPECT_TRUE(same(photons, tracePhotons(scene, lights, sampler, {}, 0, count, threads, own)))
                << "Who decides about a photon's numbers and place, it or the thread?";
            EXPECT_EQ(own.rays, counts.rays);
        }
    }
}

// Further photons go on where the last ones ended: 1000 and the next 1500 are the 2500, but for their share.
TEST(TracePhotons, GoesOnWithTheNextPhoton) {
    const Scene scene(closedBox());
    const LightChoice lights(scene.lights());
    RayCounts counts;
    const auto all = tracePhotons(scene, lights, sampler, {}, 300, 2500, 1, counts);
    auto parts = tracePhotons(scene, lights, sampler, {}, 300, 1000, 1, counts);
    const auto more = tracePhotons(scene, lights, sampler, {}, 1300, 1500, 1, counts);
    for (Photon& photon : parts) photon.power *= 1000.0 / 2500;
    for (Photon photon : more) {
        photon.power *= 1500.0 / 2500;
        parts.push_back(photon);
    }
    ASSERT_EQ(parts.size(), all.size()) << "Do a photon's numbers belong to its own number?";
    for (std::size_t i = 0; i < all.size(); ++i) {
        EXPECT_EQ(all[i].point, parts[i].point) << "Do a photon's numbers belong to its own number?";
        EXPECT_LE((all[i].power - parts[i].power).abs().maxCoeff(), 1e-12) << "Which count is power shared by?";
    }
}

}  // namespace
}  // namespace caustic
