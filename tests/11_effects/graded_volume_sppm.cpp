#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "camera/box_filter.h"
#include "camera/pinhole_camera.h"
#include "integrator/render.h"
#include "integrator/volume_sppm.h"
#include "light/constant_environment.h"
#include "light/point_light.h"
#include "material/diffuse_material.h"
#include "material/mirror_material.h"
#include "material/refraction_material.h"
#include "medium/henyey_greenstein.h"
#include "medium/homogeneous_medium.h"
#include "modeler/objects.h"
#include "sampling/sobol_sampler.h"
#include "shape/plane.h"
#include "shape/rectangle.h"
#include "shape/sphere.h"
#include "texture/constant_texture.h"

namespace caustic {
namespace {

constexpr Real pi = std::numbers::pi;
constexpr Real g = 0.4;

struct Fog {
    Vec3 centre;
    Real radius;
    Color sigmaA;
    Color sigmaS;

    SceneObject object() const {
        const auto medium = std::make_shared<HomogeneousMedium>(sigmaA, sigmaS, std::make_shared<HenyeyGreenstein>(g));
        return {.shape = std::make_shared<Sphere>(centre, radius), .interior = Interior{1, medium, 0}};
    }

    // t at which a ray is in it.
    std::pair<Real, Real> inside(const Ray& ray) const {
        const Real middle = (centre - ray.origin).dot(ray.direction);
        const Real half = std::sqrt(radius * radius - (ray.at(middle) - centre).squaredNorm());
        return {middle - half, middle + half};
    }

    Color passed(const Ray& ray) const {
        const auto [enter, leave] = inside(ray);
        return (-(sigmaA + sigmaS) * (leave - enter)).exp();
    }

    // Light of a point outside that it scatters once along the ray, by the sum over 20,000 places.
    Color scatteredOnce(const Ray& ray, const Vec3& light, const Color& intensity) const {
        constexpr int places = 20'000;
        const auto [enter, leave] = inside(ray);
        Color sum = Color::Zero();
        for (int i = 0; i < places; ++i) {
            const Real t = enter + (i + 0.5) / places * (leave - enter);
            const Vec3 way = light - ray.at(t);
            const Real distance = way.norm();
            const Ray shadow = {ray.at(t), way / distance};
            const Real dimmed = t - enter + std::min(distance, inside(shadow).second);
            const Real phase = HenyeyGreenstein(g).p(-ray.direction, shadow.direction);
            sum += sigmaS * (-(sigmaA + sigmaS) * dimmed).exp() * intensity * phase / (distance * distance);
        }
        return sum * ((leave - enter) / places);
    }
};

// One pixel, so narrow that it is a single ray along x.
std::shared_ptr<const Camera> alongX(const Vec3& from) {
    return std::make_shared<PinholeCamera>(from, from + Vec3::UnitX(), Vec3::UnitZ(), 1e-6, 1, 1);
}

// VolumeSppm without photons: what is seen, and direct light.
struct Eye {
    Eye(const SceneDescription& description, int mostSegments)
        : scene(description), sppm(scene, sampler, filter, settingsFor(mostSegments)) {}

    static VolumeSppmSettings settingsFor(int mostSegments) {
        VolumeSppmSettings settings;
        settings.limits.maxLength = mostSegments;
        settings.photons = 0;
        return settings;
    }

    Scene scene;
    SobolSampler sampler{1};
    BoxFilter filter;
    VolumeSppm sppm;
};

// In the first pixel.
Color seen(const SceneDescription& description, int mostSegments, std::int64_t paths) {
    Eye eye(description, mostSegments);
    return render(eye.sppm, {.passes = paths}).film.value({0, 0});
}

// Along a ray, which needn't be a pixel's.
Color seenAlong(const SceneDescription& description, const Ray& ray, int mostSegments, int paths = 1) {
    Eye eye(description, mostSegments);
    render(eye.sppm, {.passes = 1});
    RayCounts counts;
    Color sum = Color::Zero();
    for (int i = 0; i < paths; ++i)
        sum += eye.sppm.Li(ray, eye.scene.mediaAt(ray.origin), eye.sampler.start(0, {0, 0}, i), counts) / paths;
    return sum;
}

void expectColor(const Color& found, const Color& expected, Real tolerance, const std::string& question) {
    for (int channel = 0; channel < 3; ++channel)
        EXPECT_NEAR(found[channel] / expected[channel], 1, tolerance) << "channel " << channel << ": " << question;
}

const Fog thick = {{2, 0.1, 0.2}, 1, {1.2, 0.1, 0.5}, {0.3, 0.2, 0.8}};
const Fog thin = {{5, -0.2, 0.1}, 1.5, {0.1, 0.2, 0}, {0.2, 0.1, 0.3}};
const Ray view = {Vec3::Zero(), Vec3::UnitX()};

// Rays aslant, in several octants.
std::vector<Ray> aslant() {
    std::vector<Ray> rays;
    for (const Vec3& way : {Vec3(0.6, 0.5, -0.7), Vec3(-0.8, 0.3, 0.4), Vec3(0.5, -0.7, 0.2)})
        rays.push_back({Vec3(1, -2, 0.5), way.normalized()});
    return rays;
}

const Color shine(4, 0.5, 7);

// Smoke on the ray, which absorbs only.
Fog smokeOn(const Ray& ray) { return {ray.at(3) + Vec3(0.1, 0.2, -0.1), 1, {1.2, 0.1, 0.5}, Color::Zero()}; }

// That smoke, and behind it at t = 7 a plate across the ray, which shines towards it.
SceneDescription smokeAndPlate(const Ray& ray, const std::shared_ptr<const Material>& material) {
    const Vec3 s = ray.direction.unitOrthogonal();
    const Vec3 t = ray.direction.cross(s);
    SceneObject plate;
    plate.shape = std::make_shared<Rectangle>(ray.at(7) - s - t, 2 * t, 2 * s);
    plate.material = material;
    plate.emission = std::make_shared<ConstantTexture>(shine);
    SceneDescription description;
    description.objects = {smokeOn(ray).object(), plate};
    description.camera = alongX(view.origin);
    return description;
}

// Environment and lamp behind coloured fog, in paths of one segment: what passes, exactly.
TEST(VolumeSppm, DimsWhatLiesBehind) {
    SceneDescription description;
    description.objects = {thick.object()};
    description.lights = {std::make_shared<ConstantEnvironment>(Color(1, 2, 3))};
    description.camera = alongX(view.origin);
    expectColor(seen(description, 1, 1), Color(1, 2, 3) * thick.passed(view), 1e-5, "What passes of the environment?");
    description.objects.push_back(rectangleLamp({9, -1, -1}, {0, 0, 2}, {0, 2, 0}, {4, 5, 6}));
    expectColor(seen(description, 1, 1), Color(4, 5, 6) * thick.passed(view), 1e-5, "What passes of the lamp's light?");
    // Aslant, to the last digits, and there may be more segments than it takes.
    for (const Ray& ray : aslant()) {
        const Color passed = smokeOn(ray).passed(ray);
        SceneDescription lamp = smokeAndPlate(ray, nullptr);
        expectColor(seenAlong(lamp, ray, 3), shine * passed, 1e-11, "A lamp without a material scatters nothing.");
        lamp.objects.pop_back();
        lamp.lights = {std::make_shared<ConstantEnvironment>(Color(1, 2, 3))};
        expectColor(seenAlong(lamp, ray, 3), Color(1, 2, 3) * passed, 1e-11, "What passes of the sky's light?");
    }
}

// A point light beside two balls of fog, one behind the other: the second one's light comes through the first.
TEST(VolumeSppm, AddsOneMediumBehindTheOther) {
    const Vec3 lamp(4, 3, 0.5);
    const Color intensity(30, 20, 10);
    SceneDescription description;
    description.objects = {thick.object(), thin.object()};
    description.lights = {std::make_shared<PointLight>(lamp, intensity)};
    description.camera = alongX(view.origin);
    const Color expected =
        thick.scatteredOnce(view, lamp, intensity) + thick.passed(view) * thin.scatteredOnce(view, lamp, intensity);
    expectColor(seen(description, 2, 4096), expected, 0.03,
                "What has the first medium left of the second one's light?");
    EXPECT_EQ(seen(description, 1, 16).maxCoeff(), 0) << "From the eye to the medium to the lamp: two segments.";
}

// The same fog in a coloured mirror.
TEST(VolumeSppm, GathersOverMirrors) {
    const Color tint(0.9, 0.5, 0.7);
    const Vec3 lamp(4.5, 2, 1);
    const Color intensity(30, 20, 10);
    SceneDescription description;
    const Vec3 eye(0, 0, 0);
    description.objects = {
        thin.object(),
        {std::make_shared<Plane>(Vec3(-1, 0, 0), Vec3::UnitX()), std::make_shared<MirrorMaterial>(tint), {}, nullptr}};
    description.lights = {std::make_shared<PointLight>(lamp, intensity)};
    description.camera = std::make_shared<PinholeCamera>(eye, Vec3(-1, 0, 0), Vec3::UnitZ(), 1e-6, 1, 1);
    const Ray second = {Vec3(-1, 0, 0), Vec3::UnitX()};
    expectColor(seen(description, 3, 4096), tint * thin.scatteredOnce(second, lamp, intensity), 0.03,
                "What has the mirror left of the path?");
    EXPECT_EQ(seen(description, 2, 16).maxCoeff(), 0) << "The way to the mirror is a segment, too.";
    // Into glass of index 1.5, in which a lamp hangs: radiance is smaller outside by the square of it.
    const Color passes(0.9, 0.5, 0.7);
    description.lights.clear();
    description.objects = {
        {std::make_shared<Plane>(Vec3::Zero(), Vec3::UnitZ()),
         std::make_shared<RefractionMaterial>(Color::Zero(), passes), Interior{1.5, nullptr, 0}, nullptr},
        rectangleLamp({-9, -9, -1}, {18, 0, 0}, {0, 18, 0}, shine)};
    expectColor(seenAlong(description, {Vec3(0, 0, 2), Vec3(0.3, 0.2, -1).normalized()}, 3), shine * passes / 2.25,
                1e-9, "Is it radiance that comes along the path?");
}

// A diffuse wall behind fog that absorbs only: its light is dimmed on both ways, exactly.
TEST(VolumeSppm, DimsTheLightOfSurfaces) {
    const Color albedo(0.8, 0.4, 0.6);
    const Color intensity(3, 2, 5);
    const Vec3 lamp(8, 1, 0.5);
    const Fog smoke = {{2, 0.1, 0.2}, 1, {1.2, 0.1, 0.5}, Color::Zero()};
    SceneDescription description;
    description.objects = {smoke.object(),
                           {std::make_shared<Plane>(Vec3(9, 0, 0), -Vec3::UnitX()),
                            std::make_shared<DiffuseMaterial>(albedo),
                            {},
                            nullptr}};
    description.lights = {std::make_shared<PointLight>(lamp, intensity)};
    description.camera = alongX(view.origin);
    const Vec3 way = lamp - Vec3(9, 0, 0);
    const Color lit = albedo / pi * intensity * (-way.x() / std::pow(way.norm(), 3));
    expectColor(seen(description, 2, 4), smoke.passed(view) * lit, 1e-6,
                "What has the smoke left on the way to the eye?");
    // A wall that shines itself. One of two lamps is chosen at random each time; Sobol's numbers share them out evenly.
    for (const Ray& ray : aslant()) {
        SceneDescription shining = smokeAndPlate(ray, std::make_shared<DiffuseMaterial>(albedo));
        const Vec3 from = -0.5 * ray.direction + 0.3 * ray.direction.unitOrthogonal();
        shining.lights = {std::make_shared<PointLight>(ray.at(7) + from, intensity)};
        const Color itsLight = albedo / pi * intensity * (0.5 / std::pow(from.norm(), 3));
        expectColor(seenAlong(shining, ray, 3, 1024), (shine + itsLight) * smokeOn(ray).passed(ray), 0.01,
                    "What was gathered before a surface's own light, and the light on it?");
    }
}

// Two mirrors face each other; zigzag between them the path comes to a lamp with its third segment.
TEST(VolumeSppm, EndsWhenPathsGetTooLong) {
    const auto mirror = std::make_shared<MirrorMaterial>(Color::Ones());
    SceneDescription description;
    description.objects = {{std::make_shared<Plane>(Vec3(1, 0, 0), -Vec3::UnitX()), mirror, {}, nullptr},
                           {std::make_shared<Plane>(Vec3(-1, 0, 0), Vec3::UnitX()), mirror, {}, nullptr},
                           rectangleLamp({-1, -1, 3.5}, {0, 2, 0}, {2, 0, 0}, {1, 2, 3})};
    description.camera = std::make_shared<PinholeCamera>(Vec3::Zero(), Vec3(1, 0, 1), Vec3::UnitZ(), 1e-6, 1, 1);
    expectColor(seen(description, 3, 1), {1, 2, 3}, 1e-9, "A path of three segments, of three that it may have?");
    EXPECT_EQ(seen(description, 2, 1).maxCoeff(), 0) << "Where does a path of two segments end?";
    // Mirrors that shine themselves: what was gathered counts, though the path is as long as it may be, or is absorbed.
    for (const Ray& ray : aslant()) {
        const Color expected = shine * smokeOn(ray).passed(ray);
        expectColor(seenAlong(smokeAndPlate(ray, mirror), ray, 1), expected, 1e-11, "A path of one segment, of one?");
        const auto black = std::make_shared<MirrorMaterial>(Color::Zero());
        expectColor(seenAlong(smokeAndPlate(ray, black), ray, 9), expected, 1e-11, "And where no lobe leads on?");
    }
}

}  // namespace
}  // namespace caustic
