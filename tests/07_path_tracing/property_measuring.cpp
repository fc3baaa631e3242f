#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "camera/box_filter.h"
#include "core/error.h"
#include "image/picture_error.h"
#include "integrator/near_lamps.h"
#include "integrator/render.h"
#include "measures/caustic_reference.h"
#include "measures/measured_scenes.h"
#include "measures/radiosity.h"
#include "methods.h"
#include "sampling/independent_sampler.h"
#include "support/form_factor.h"

namespace caustic {
namespace {

const IndependentSampler sampler(3);
const BoxFilter box;

TEST(Rmse, IsTheRootOfTheMeanSquareOverPixelsAndChannels) {
    Image picture(2, 1);
    picture.set(0, 0, Color(3, 0, 0));
    picture.set(1, 0, Color(0, 0, 4));
    EXPECT_DOUBLE_EQ(rmse(picture, Image(2, 1)), std::sqrt(25.0 / 6));
    EXPECT_DOUBLE_EQ(rmse(picture, Image(2, 1), {true, false}), std::sqrt(16.0 / 3));
    EXPECT_EQ(rmse(picture, picture), 0);
}

TEST(Rmse, RefusesWhatCannotBeCompared) {
    EXPECT_THROW(rmse(Image(2, 1), Image(1, 2)), InputError);
    EXPECT_THROW(rmse(Image(2, 1), Image(2, 1), {true, true}), InputError);
    EXPECT_THROW(rmse(Image(2, 1), Image(2, 1), {true}), InputError);
}

TEST(Shrunk, KeepsTheMean) {
    Image picture(4, 2);
    picture.set(0, 0, Color(4, 0, 0));
    picture.set(3, 1, Color(0, 8, 0));
    const Image small = shrunk(picture, 2);
    EXPECT_EQ(small.height(), 1);
    EXPECT_EQ(small.at(0, 0).x(), 1);
    EXPECT_EQ(small.at(1, 0).y(), 2);
    EXPECT_THROW(shrunk(picture, 3), InputError);
}

// Pass after pass is the same as all at once: the same numbers belong to the same paths.
TEST(Render, StopsWhenItIsTold) {
    const Scene scene(DiffuseBox{}.scene(12, 12));
    for (const Method method : allMethods) {
        const auto integrator = makeIntegrator(method, scene, sampler, box, 6);
        const Rendering told = render(*integrator, {.look = [](const Rendering& soFar) { return soFar.passes < 5; }});
        EXPECT_EQ(told.passes, 5);
        EXPECT_EQ(rmse(told.film.image(), render(*integrator, {.passes = 5, .threads = 2}).film.image()), 0)
            << nameOf(method);
    }
}

TEST(Render, EndsInTime) {
    const Scene scene(DiffuseBox{}.scene(12, 12));
    const auto integrator = makeIntegrator(Method::Mis, scene, sampler, box, 6);
    for (const int threads : {1, 2}) {
        const Rendering rendering = render(*integrator, {.seconds = 1e-9, .threads = threads});
        EXPECT_EQ(rendering.passes, 1) << "one pass is done in any case";
        EXPECT_GT(rendering.seconds, 0);
        EXPECT_THROW(render(*integrator, {.seconds = 0, .threads = threads}), InputError);
        EXPECT_THROW(render(*integrator, {.seconds = std::nan(""), .threads = threads}), InputError);
    }
    EXPECT_THROW(render(*integrator, {.passes = 0}), InputError);
    EXPECT_THROW(render(*integrator, {.passes = 1, .threads = 0}), InputError);
    EXPECT_THROW(render(*integrator, {}), InputError) << "nothing says when to end";
}

// A place on the floor: ρ L times the lamp's form factor, which tests/support has on its own, comes straight from the
// lamp, and less than as much again over the walls.
TEST(BoxRadiosity, ShowsDirectLightInClosedForm) {
    DiffuseBox dim;
    dim.lampSide = 0.8;
    const SceneDescription scene = dim.scene(8, 8);
    const BoxRadiosity radiosity(dim, 10, 2);
    const Image picture = radiosity.picture(*scene.camera, 1, 2);
    const Ray ray = scene.camera->sampleRay({4.5, 7.5}, {0.5, 0.5});
    const Vec3 at = ray.at((-1 - ray.origin.z()) / ray.direction.z());
    ASSERT_LT(at.cwiseAbs().maxCoeff(), 1 + 1e-9);
    const Real direct =
        0.75 * dim.radiance * test::formFactor(-0.4 - at.x(), 0.4 - at.x(), -0.4 - at.y(), 0.4 - at.y(), 2);
    EXPECT_GT(picture.at(4, 7).x(), direct);
    EXPECT_LT(picture.at(4, 7).x(), 2 * direct);
}

// Path tracing shares nothing with radiosity, nor with the caustic's own program: means over the whole picture.
TEST(References, AgreeWithPathTracingAndLightTracing) {
    const auto meanOf = [](const Image& picture) {
        Color sum = Color::Zero();
        for (int i = 0; i < 16 * 16; ++i) sum += picture.at(i % 16, i / 16) / (16 * 16);
        return sum;
    };
    for (const bool mirror : {false, true}) {
        const DiffuseBox both = mirror ? DiffuseBox{.lampSide = 0.6, .mirror = true} : DiffuseBox{};
        const SceneDescription description = both.scene(16, 16);
        const Scene scene(description);
        const Color truth = meanOf(BoxRadiosity(both, 10, 2).picture(*description.camera, 32, 2));
        const auto integrator = makeIntegrator(Method::Mis, scene, sampler, box, 64);
        const Color seen = meanOf(render(*integrator, {.passes = 2000, .threads = 2}).film.image());
        EXPECT_LE(((seen - truth).abs() / truth).maxCoeff(), 0.01) << "mirror: " << mirror;
    }
    const Scene caustic(CausticScene{}.onFloor(16));
    const auto light = makeIntegrator(Method::Light, caustic, sampler, box, 64);
    const Real truth = meanOf(causticReference({}, 16, 400'000, 2, 5)).x();
    EXPECT_NEAR(meanOf(render(*light, {.passes = 4000, .threads = 2}).film.image()).x(), truth, 0.01 * truth);
}

// The charts leave out what is near lamps: of the boxes nothing, since their lamps are out of view.
TEST(MeasuredScenes, LampsAreSeenInThePeersBoxOnly) {
    for (const MeasuredScene& one : measuredScenes()) {
        const auto near = pixelsNearLamps(Scene(one.make(32)), 2);
        const auto count = std::count(near.begin(), near.end(), true);
        if (one.name == "peers_box") {
            EXPECT_GT(count, 20);
            EXPECT_LT(count, 200);
        } else {
            EXPECT_EQ(count, 0) << one.name;
        }
    }
    EXPECT_THROW(measuredScene("elsewhere"), InputError);
}

}  // namespace
}  // namespace caustic
