#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <memory>

#include "camera/box_filter.h"
#include "core/error.h"
#include "integrator/photon_mapper.h"
#include "light/point_light.h"
#include "material/diffuse_material.h"
#include "material/mirror_material.h"
#include "modeler/objects.h"
#include "sampling/independent_sampler.h"

namespace caustic {
namespace {

const IndependentSampler sampler(3);
const BoxFilter filter;

SceneDescription floorUnder(std::vector<std::shared_ptr<Light>> lights, bool mirror = false) {
    SceneObject floor = diffuseRectangle({-9, -9, 0}, {18, 0, 0}, {0, 18, 0}, Color::Constant(0.5));
    if (mirror) floor.material = std::make_shared<MirrorMaterial>(Color::Constant(0.5));
    return {{floor}, std::move(lights), Color::Zero(), nullptr};
}

std::shared_ptr<Light> lamp(Real intensity) {
    return std::make_shared<PointLight>(Vec3(0, 0, 2), Color::Constant(intensity));
}

Color seen(const Scene& scene, const PhotonMapperSettings& settings) {
    RayCounts counts;
    return PhotonMapper(scene, sampler, filter, settings, 1)
        .Li({Vec3(1, 0, 1), Vec3(-1, 0, -1).normalized()}, {}, sampler.start(0, {0, 0}, 0), counts);
}

// Each setting that is out of its range is refused, and the message says which.
TEST(PhotonSettings, OutOfRangeAreRefused) {
    const Scene scene(floorUnder({lamp(1)}));
    const Real nan = std::numeric_limits<Real>::quiet_NaN();
    const Real infinity = std::numeric_limits<Real>::infinity();
    const std::vector<std::pair<std::string, std::function<void(PhotonMapperSettings&)>>> wrong = {
        {"photons", [](PhotonMapperSettings& s) { s.photons = 0; }},
        {"photons", [](PhotonMapperSettings& s) { s.photons = -5; }},
        {"longest path", [](PhotonMapperSettings& s) { s.limits.maxLength = 0; }},
        {"roulette", [](PhotonMapperSettings& s) { s.limits.rouletteStart = -1; }},
        {"splits", [](PhotonMapperSettings& s) { s.splits = -1; }},
        {"splits", [](PhotonMapperSettings& s) { s.splits = 17; }},
        {"nearest", [](PhotonMapperSettings& s) { s.density.nearest = 0; }},
        {"nearest", [](PhotonMapperSettings& s) { s.caustics.nearest = -3; }},
        {"radius", [](PhotonMapperSettings& s) { s.density.radius = 0; }},
        {"radius", [](PhotonMapperSettings& s) { s.density.radius = -1; }},
        {"radius", [=](PhotonMapperSettings& s) { s.caustics.radius = nan; }},
        {"radius", [=](PhotonMapperSettings& s) { s.caustics.radius = infinity; }},
        {"cone", [](PhotonMapperSettings& s) { s.density.cone = 0.5; }},
        {"cone", [=](PhotonMapperSettings& s) { s.density.cone = nan; }},
        {"gather", [](PhotonMapperSettings& s) { s.gatherRays = 0; }}};
    for (const auto& [what, spoil] : wrong) {
        PhotonMapperSettings settings = {.photons = 10};
        spoil(settings);
        try {
            const PhotonMapper refused(scene, sampler, filter, settings, 1);
            ADD_FAILURE() << what;
        } catch (const InputError& error) {
            EXPECT_NE(std::string(error.what()).find(what), std::string::npos) << error.what();
        }
    }
    RayCounts counts;
    EXPECT_THROW(tracePhotons(scene, LightChoice(scene.lights()), sampler, {}, 0, 0, 1, counts), InputError);
}

// No light, light of no power, nothing that spreads it: no photon, a reason, and a black picture.
TEST(PhotonMapping, SaysWhyThereAreNoPhotons) {
    for (const auto& lights : {std::vector<std::shared_ptr<Light>>{}, {lamp(0)}}) {
        const Scene scene(floorUnder(lights));
        const PhotonMapper mapper(scene, sampler, filter, {.photons = 100}, 1);
        EXPECT_NE(mapper.whyNoPhotons().find("no light"), std::string::npos);
        EXPECT_EQ(mapper.photonCounts().rays, 0);
        EXPECT_TRUE((seen(scene, {.photons = 100}) == 0).all());
    }
    const Scene mirrors(floorUnder({lamp(1)}, true));
    const PhotonMapper mapper(mirrors, sampler, filter, {.photons = 100}, 1);
    EXPECT_NE(mapper.whyNoPhotons().find("no surface"), std::string::npos);
    EXPECT_EQ(mapper.photonCounts().rays, 0);
    EXPECT_TRUE((seen(mirrors, {.photons = 100}) == 0).all());
    const Scene empty({{}, {lamp(1)}, Color::Zero(), nullptr});
    EXPECT_TRUE((seen(empty, {.photons = 100}) == 0).all());
}

// One photon, or fewer than asked for, or all at the same place: finite light, and none that isn't there.
TEST(PhotonMapping, TakesFewPhotons) {
    const Scene scene(floorUnder({lamp(1)}));
    for (const std::int64_t photons : {1, 2, 49, 50, 51}) {
        for (const MapUse use : {MapUse::Everything, MapUse::Indirect, MapUse::Gather}) {
            const Color found = seen(scene, {.photons = photons, .use = use});
            EXPECT_TRUE(found.allFinite());
            EXPECT_TRUE((found >= 0).all());
        }
    }
    MediumStack media;
    Color passed;
    RayCounts counts;
    const Interaction at = *scene.follow({Vec3(0, 0, 1), -Vec3::UnitZ()}, media, passed, counts);
    const std::vector<Photon> stack(100,
                                    {Vec3::Zero(), Vec3::UnitZ(), Color::Ones(), Vec3::UnitZ(), 1, PhotonWay::Direct});
    for (const auto& nearest :
         {std::optional<int>(1), std::optional<int>(99), std::optional<int>(500), std::optional<int>()})
        EXPECT_TRUE(PhotonMap(stack).radiance(at, {.nearest = nearest, .radius = 0.1}).allFinite());
}

}  // namespace
}  // namespace caustic
