#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <string>

#include "camera/box_filter.h"
#include "camera/pinhole_camera.h"
#include "core/error.h"
#include "core/random.h"
#include "integrator/ray_tracer.h"
#include "integrator/render.h"
#include "light/area_light.h"
#include "light/cone_light.h"
#include "light/constant_environment.h"
#include "light/point_light.h"
#include "material/diffuse_material.h"
#include "material/directions.h"
#include "material/mirror_material.h"
#include "material/phong_material.h"
#include "material/refraction_material.h"
#include "medium/absorbing_medium.h"
#include "sampling/independent_sampler.h"
#include "sampling/stratified_sampler.h"
#include "sampling/warp.h"
#include "shape/box.h"
#include "shape/instance.h"
#include "shape/plane.h"
#include "shape/rectangle.h"
#include "shape/sphere.h"
#include "support/in_cube.h"
#include "texture/checker_texture.h"
#include "texture/constant_texture.h"

namespace caustic {
namespace {

const Real nan = std::numeric_limits<Real>::quiet_NaN();
const Real infinity = std::numeric_limits<Real>::infinity();
const IndependentSampler sampler(1);
const BoxFilter box;

std::shared_ptr<const Texture> white(Real value = 1) {
    return std::make_shared<ConstantTexture>(Color::Constant(value));
}

// Refraction at and around the critical angle, at grazing incidence, at IOR 1 and far from it: unit directions or none.
TEST(Refraction, SurvivesEveryAngleAndIndex) {
    for (const Real eta : {1e-3, 0.3, 1 / 1.5, 1.0, 1 + 1e-15, 1.5, 100.0}) {
        for (const Real cosine : {0.0, 1e-300, 1e-12, std::sqrt(1 - std::min(Real(1), eta * eta)), 0.5, 1.0}) {
            for (const Real nudge : {0.0, 1e-16, -1e-16, 1e-9}) {
                const Real c = std::clamp(cosine + nudge, 0.0, 1.0);
                const Vec3 wo(std::sqrt(1 - c * c), 0, c);
                const auto wi = refracted(wo, Vec3::UnitZ(), eta);
                const Real sine = wo.x() / eta;
                if (std::abs(sine - 1) > 1e-7) {
                    EXPECT_EQ(wi.has_value(), sine < 1) << eta << " " << c;
                }
                if (!wi) continue;
                EXPECT_NEAR(wi->norm(), 1, 1e-14);
                EXPECT_LE(wi->z(), 0);
                EXPECT_NEAR(-wi->x(), sine, 1e-7);
            }
        }
    }
    const Vec3 wo = Vec3(1, 2, 3).normalized();
    EXPECT_LE((*refracted(wo, Vec3::UnitZ(), 1) + wo).norm(), 1e-15) << "IOR 1 bends nothing";
}

// Random scenes of overlapping balls of every material, seen from outside and from within: no sample is not a number.
TEST(RayTracer, NoSampleIsNotANumber) {
    for (std::uint64_t i = 0; i < 40; ++i) {
        Random random(2, {i});
        const std::shared_ptr<const Material> materials[] = {
            std::make_shared<DiffuseMaterial>(Color(0.2, 0.5, 1)), std::make_shared<MirrorMaterial>(Color::Ones()),
            std::make_shared<RefractionMaterial>(Color::Constant(0.1), Color::Constant(0.9)),
            std::make_shared<PhongMaterial>(white(0.5), Color::Constant(0.5), random.uniform(0, 500))};
        SceneDescription description;
        for (int k = 0; k < 7; ++k) {
            SceneObject ball;
            ball.shape = std::make_shared<Sphere>(test::inCube(random), random.uniform(0.1, 0.8));
            ball.material = materials[random.below(4)];
            if (random.below(2) == 0)
                ball.interior = Interior{random.uniform(0.5, 2.5),
                                         std::make_shared<AbsorbingMedium>(Color(random.uniform(0, 9), 0, 1)),
                                         static_cast<int>(random.below(3))};
            if (random.below(5) == 0) ball.emission = white(3);
            description.objects.push_back(ball);
        }
        description.lights = {std::make_shared<PointLight>(test::inCube(random), Color::Ones()),
                              std::make_shared<ConstantEnvironment>(Color::Constant(0.5))};
        description.ambient = Color::Constant(0.1);
        description.camera = std::make_shared<PinholeCamera>(3 * test::inCube(random), test::inCube(random),
                                                             Vec3(0.1, 1, 0.2), 0.9, 16, 16);
        const Scene scene(description);
        RayTracer tracer(scene, sampler, box, {.maxDepth = 6, .shadowSamples = 2});
        const Rendering rendering = render(tracer, {.passes = 1});
        EXPECT_EQ(rendering.film.badSamples(), 0) << "scene " << i;
        for (int p = 0; p < 256; ++p) EXPECT_GE(rendering.film.value({p % 16, p / 16}).minCoeff(), 0);
    }
}

// Lights in odd places: at the lit point, in the lit plane, touching a wall, inside glass.
TEST(RayTracer, LightsInOddPlaces) {
    const auto diffuse = std::make_shared<DiffuseMaterial>(Color::Ones());
    const SceneObject floor = {.shape = std::make_shared<Plane>(Vec3::Zero(), Vec3::UnitY()), .material = diffuse};
    SceneObject touching;
    touching.shape = std::make_shared<Rectangle>(Vec3(1, 0, 0), Vec3(0, 0, 1), Vec3(0, 1, 0));  // stands on the floor
    touching.emission = white();
    SceneObject glass = {.shape = std::make_shared<Sphere>(Vec3(-2, 1, 0), 0.5),
                         .material = std::make_shared<RefractionMaterial>(Color::Zero(), Color::Ones()),
                         .interior = Interior{1.5, nullptr, 0}};
    const Scene scene({.objects = {floor, touching, glass},
                       .lights = {std::make_shared<PointLight>(Vec3::Zero(), Color::Ones()),
                                  std::make_shared<PointLight>(Vec3(-2, 1, 0), Color::Ones())}});
    const RayTracer tracer(scene, sampler, box, {.maxDepth = 8, .shadowSamples = 4});
    RayCounts counts;
    for (std::uint64_t i = 0; i < 2000; ++i) {
        Random random(3, {i});
        const Vec3 target(random.uniform(-3, 1.5), 0, random.uniform(-1, 1));
        const Ray ray = {Vec3(0, 1, 3), (target - Vec3(0, 1, 3)).normalized()};
        EXPECT_TRUE(
            tracer.Li(ray, {}, sampler.start(0, {0, 0}, static_cast<std::int64_t>(i)), counts).isFinite().all());
    }
    const Color below = tracer.Li({Vec3(0, 1, 0), -Vec3::UnitY()}, {}, sampler.start(0, {0, 0}, 0), counts);
    EXPECT_TRUE(below.isFinite().all()) << "the light is the lit point";
}

// Two panes that overlap by a millionth, as Interior asks for, pass all light. With a common face, a ray that leaves
// one of them is past the other's face already: what it sees is wrong there, but a number.
TEST(RayTracer, SurfacesInContact) {
    const auto clear = std::make_shared<RefractionMaterial>(Color::Zero(), Color::Ones());
    const auto paneOf = [&](Real from, Real to) {
        return SceneObject{.shape = std::make_shared<Box>(Vec3(from, -9, -9), Vec3(to, 9, 9)),
                           .material = clear,
                           .interior = Interior{1.5, nullptr, 0}};
    };
    for (const Real overlap : {1e-6, 0.0}) {
        const Scene scene({.objects = {paneOf(0, 1 + overlap), paneOf(1, 2)},
                           .lights = {std::make_shared<ConstantEnvironment>(Color::Ones())}});
        const RayTracer tracer(scene, sampler, box, {});
        RayCounts counts;
        for (std::uint64_t i = 0; i < 1000; ++i) {
            Random random(4, {i});
            const Vec3 direction(1, random.uniform(-0.3, 0.3), random.uniform(-0.3, 0.3));
            const Ray ray = {Vec3(-1, 0, 0), direction.normalized()};
            const Color seen = tracer.Li(ray, {}, sampler.start(0, {0, 0}, 0), counts);
            EXPECT_TRUE(seen.isFinite().all());
            if (overlap > 0) {
                EXPECT_NEAR(seen.x(), 1, 1e-9);
            }
        }
    }
}

TEST(MediumStack, HasABottom) {
    const Interior glass;
    MediumStack media;
    for (ObjectId i = 0; i < MediumStack::mostNested; ++i) media.enter(i, glass);
    const auto reasonFor = [&](ObjectId object) -> std::string {
        try {
            media.enter(object, glass);
        } catch (const InputError& error) {
            return error.reason();
        }
        return "";
    };
    EXPECT_NE(reasonFor(99).find("overlap"), std::string::npos);
    EXPECT_NE(reasonFor(5).find("isn't closed"), std::string::npos);
    EXPECT_EQ(media.object(), 0) << "among equals the smallest id";
    media.leave(50);
    EXPECT_TRUE(media.contains(7));
}

TEST(AbsorbingMedium, SurvivesExtremes) {
    const AbsorbingMedium medium(Color(0, 1e308, 1e-300));
    const Color passed = medium.transmittance({Vec3::Zero(), Vec3(0, 0, 2)}, infinity);
    EXPECT_EQ(passed.x(), 1);
    EXPECT_EQ(passed.y(), 0);
    EXPECT_EQ(passed.z(), 0);
    EXPECT_TRUE((medium.transmittance({Vec3::Zero(), Vec3::UnitZ()}, 0) == 1).all());
    const AbsorbingMedium green = AbsorbingMedium::ofTransmittance(Color(0.5, 1, 0.25));
    EXPECT_NEAR(green.transmittance({Vec3::Zero(), Vec3::UnitZ()}, 3).x(), 0.125, 1e-15) << "the report's I to the d";
    EXPECT_EQ(green.sigmaA().y(), 0);
}

TEST(BadInput, MaterialsAndMedia) {
    EXPECT_THROW(DiffuseMaterial(Color(0, 0, 1.01)), InputError);
    EXPECT_THROW(DiffuseMaterial(Color(0, 0, -0.1)), InputError);
    EXPECT_THROW(DiffuseMaterial(std::shared_ptr<const Texture>()), InputError);
    EXPECT_THROW(MirrorMaterial(Color(nan, 0, 0)), InputError);
    EXPECT_THROW(RefractionMaterial(Color::Constant(0.6), Color::Constant(0.6)), InputError);
    EXPECT_THROW(PhongMaterial(white(0.6), Color::Constant(0.6), 10), InputError);
    EXPECT_THROW(PhongMaterial(white(0.1), Color::Constant(0.6), -1), InputError);
    EXPECT_THROW(PhongMaterial(white(0.1), Color::Constant(0.6), nan), InputError);
    EXPECT_THROW(PhongMaterial(nullptr, Color::Constant(0.6), 1), InputError);
    EXPECT_THROW(AbsorbingMedium(Color(-1, 0, 0)), InputError);
    EXPECT_THROW(AbsorbingMedium(Color(infinity, 0, 0)), InputError);
    EXPECT_THROW(AbsorbingMedium::ofTransmittance(Color(0, 1, 1)), InputError);
    EXPECT_THROW(AbsorbingMedium::ofTransmittance(Color(1.1, 1, 1)), InputError);
    EXPECT_THROW(ConstantTexture(Color(-1, 0, 0)), InputError);
    EXPECT_THROW(CheckerTexture(Color::Ones(), Color::Ones(), 0), InputError);
}

TEST(BadInput, LightsAndShapes) {
    EXPECT_THROW(PointLight({nan, 0, 0}, Color::Ones()), InputError);
    EXPECT_THROW(PointLight({0, 0, 0}, Color(-1, 0, 0)), InputError);
    EXPECT_THROW(ConeLight({0, 0, 0}, {0, 0, 0}, 1, Color::Ones()), InputError);
    EXPECT_THROW(ConeLight({0, 0, 0}, {0, 0, 1}, 0, Color::Ones()), InputError);
    EXPECT_THROW(ConeLight({0, 0, 0}, {0, 0, 1}, 4, Color::Ones()), InputError);
    EXPECT_THROW(ConstantEnvironment(Color(infinity, 0, 0)), InputError);
    EXPECT_THROW(AreaLight(std::make_shared<Plane>(Vec3::Zero(), Vec3::UnitY()), white()), InputError);
    EXPECT_THROW(AreaLight(nullptr, white()), InputError);
    EXPECT_THROW(AreaLight(std::make_shared<Sphere>(Vec3::Zero(), 1.0), nullptr), InputError);
    EXPECT_THROW(Sphere({0, 0, 0}, -1), InputError);
    EXPECT_THROW(Instance(std::make_shared<Sphere>(Vec3::Zero(), 1.0), Transform::scaling({1, 0, 1})), InputError);
    EXPECT_THROW(Rectangle({0, 0, 0}, {1, 0, 0}, {1, 1, 0}), InputError);
    EXPECT_THROW(Rectangle({0, 0, 0}, {0, 0, 0}, {1, 1, 0}), InputError);
    EXPECT_THROW(Rectangle({0, nan, 0}, {1, 0, 0}, {0, 1, 0}), InputError);
}

TEST(BadInput, CameraFilmSamplerAndSettings) {
    EXPECT_THROW(PinholeCamera({0, 0, 0}, {0, 0, 0}, {0, 1, 0}, 1, 9, 9), InputError) << "looks nowhere";
    EXPECT_THROW(PinholeCamera({0, 0, 0}, {0, 1, 0}, {0, 1, 0}, 1, 9, 9), InputError) << "up along the view";
    EXPECT_THROW(PinholeCamera({0, 0, 0}, {0, 0, 1}, {0, 1, 0}, 0, 9, 9), InputError);
    EXPECT_THROW(PinholeCamera({0, 0, 0}, {0, 0, 1}, {0, 1, 0}, 4, 9, 9), InputError);
    EXPECT_THROW(PinholeCamera({0, 0, 0}, {0, 0, 1}, {0, 1, 0}, nan, 9, 9), InputError);
    EXPECT_THROW(PinholeCamera({0, 0, 0}, {0, 0, 1}, {0, 1, 0}, 1, 0, 9), InputError);
    EXPECT_THROW(PinholeCamera({0, 0, 0}, {0, 0, 1}, {0, 1, 0}, 1, 1 << 20, 1 << 20), InputError);
    EXPECT_THROW(PinholeCamera({0, 0, infinity}, {0, 0, 1}, {0, 1, 0}, 1, 9, 9), InputError);
    EXPECT_THROW(Film(0, 4), InputError);
    EXPECT_THROW(Film(4, -1), InputError);
    EXPECT_THROW(Film(1 << 20, 1 << 20), InputError);
    EXPECT_THROW(StratifiedSampler(1, 0), InputError);
    const Scene empty({});
    EXPECT_THROW(empty.camera(), InputError);
    EXPECT_FALSE(empty.intersect({Vec3::Zero(), Vec3::UnitX()}));
    EXPECT_THROW(RayTracer(empty, sampler, box, {.maxDepth = -1}), InputError);
    EXPECT_THROW(RayTracer(empty, sampler, box, {.shadowSamples = 0}), InputError);
    EXPECT_THROW(RayTracer(empty, sampler, box, {.leastWeight = 1}), InputError);
    RayTracer tracer(empty, sampler, box, {});
    EXPECT_THROW(render(tracer, {.passes = 0}), InputError);
    EXPECT_THROW(render(tracer, {.passes = 1}), InputError) << "there is no camera";
}

TEST(BadInput, Scenes) {
    const auto ball = std::make_shared<Sphere>(Vec3::Zero(), 1.0);
    const auto clear = std::make_shared<RefractionMaterial>(Color::Zero(), Color::Ones());
    EXPECT_THROW(Scene({.objects = {{.material = clear}}}), InputError);
    EXPECT_THROW(Scene({.objects = {{.shape = ball}}}), InputError) << "nothing at all";
    EXPECT_THROW(Scene({.objects = {{.shape = ball, .material = clear, .interior = Interior{0, nullptr, 0}}}}),
                 InputError);
    EXPECT_THROW(Scene({.objects = {{.shape = ball, .material = clear, .interior = Interior{nan, nullptr, 0}}}}),
                 InputError);
    EXPECT_THROW(Scene({.objects = {{.shape = ball, .material = clear, .interior = Interior{-1.5, nullptr, 0}}}}),
                 InputError);
    EXPECT_THROW(Scene({.objects = {{.shape = ball, .material = clear, .interior = Interior{infinity, nullptr, 0}}}}),
                 InputError);
    EXPECT_THROW(Scene({.lights = {nullptr}}), InputError);
    EXPECT_THROW(Scene({.ambient = Color(-1, 0, 0)}), InputError);
}

// A rectangle met from both sides, along its plane, beside it, at its corners.
TEST(Rectangle, MeetsWhatItShould) {
    const Rectangle one(Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(0, 3, 0));
    const auto hit = one.intersect({Vec3(0.5, 1.5, 4), Vec3(0, 0, -2)});
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->t, 2);
    EXPECT_TRUE(hit->uv.isApprox(Vec2(0.25, 0.5)));
    EXPECT_TRUE(hit->ng.isApprox(Vec3::UnitZ()));
    EXPECT_TRUE(one.occluded({Vec3(0.5, 1.5, -4), Vec3(0, 0, 1)}));
    EXPECT_TRUE(one.occluded({Vec3(0, 0, 1), Vec3(0, 0, -1)})) << "a corner belongs to it";
    EXPECT_FALSE(one.occluded({Vec3(2.001, 1, 1), Vec3(0, 0, -1)}));
    EXPECT_FALSE(one.occluded({Vec3(-1, 1, 0), Vec3(1, 0, 0)})) << "a ray within the plane";
    EXPECT_FALSE(one.occluded({Vec3(1, 1, 1), Vec3(nan, 0, -1)}));
    EXPECT_TRUE(one.bounds().isApprox(Bounds3(Vec3(0, 0, 0), Vec3(2, 3, 0))));
    EXPECT_NEAR(one.pdfA(*hit), 1.0 / 6, 1e-15);
    EXPECT_TRUE(one.sampleArea({0.5, 0.5})->at.point.isApprox(Vec3(1, 1.5, 0)));
}

}  // namespace
}  // namespace caustic
