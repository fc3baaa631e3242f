#include <cmath>
#include <numbers>
#include <optional>

#include "camera/box_filter.h"
#include "camera/pinhole_camera.h"
#include "figures.h"
#include "integrator/render.h"
#include "light/cone_light.h"
#include "light/point_light.h"
#include "material/mirror_material.h"
#include "methods.h"
#include "modeler/objects.h"
#include "sampling/independent_sampler.h"
#include "shape/rectangle.h"

namespace caustic {

namespace {

constexpr Real pi = std::numbers::pi;

// A scene of which one pixel shows what is known, and how far off an answer may be. A fragile method that isn't one of
// the chapter's has its answer here.
struct Case {
    SceneDescription scene;
    Real truth;
    Real tolerance;
    std::int64_t samples;
    std::optional<Real> naive = std::nullopt;
};

Real rendered(Method method, const Case& one, std::uint64_t seed) {
    const Scene scene(one.scene);
    const IndependentSampler sampler(seed);
    const BoxFilter filter;
    const auto integrator = makeIntegrator(method, scene, sampler, filter, 8);
    return render(*integrator, {.passes = one.samples}).film.value({0, 0}).x();
}

// One pixel that sees a small place: `half` is the tangent of half its angle.
std::shared_ptr<const Camera> pixelAt(const Vec3& eye, const Vec3& target, Real half) {
    const Vec3 up = std::abs((target - eye).normalized().z()) > 0.9 ? Vec3::UnitY() : Vec3::UnitZ();
    return std::make_shared<PinholeCamera>(eye, target, up, 2 * std::atan(half), 1, 1);
}

SceneObject floorOf(Real reflectance) {
    return diffuseRectangle({-20, -20, 0}, {40, 0, 0}, {0, 40, 0}, Color::Constant(reflectance));
}

// A mirror that stands on the floor at x = −1 and looks along x.
SceneObject standingMirror(Real reflectance, const Vec2& middle, Real half) {
    return {.shape = std::make_shared<Rectangle>(Vec3(-1, middle.x() - half, middle.y() - half), Vec3(0, 2 * half, 0),
                                                 Vec3(0, 0, 2 * half)),
            .material = std::make_shared<MirrorMaterial>(Color::Constant(reflectance))};
}

// A cone of light that a large mirror throws onto the floor, and where its axis arrives.
struct MirroredSpot {
    Real floor;
    Real mirror;
    Real intensity;
    Real halfAngle;
    Vec3 lamp;
    Vec3 target;  // on the floor, seen from the lamp behind the mirror

    explicit MirroredSpot(Random& random)
        : floor(random.uniform(0.3, 0.9)),
          mirror(random.uniform(0.3, 1)),
          intensity(random.uniform(1, 10)),
          halfAngle(random.uniform(0.01, 0.05)),
          lamp(random.uniform(-0.3, 0.3), random.uniform(-0.3, 0.3), random.uniform(0.8, 1.5)),
          target(random.uniform(0.6, 1.2), random.uniform(-0.3, 0.3), 0) {}

    Vec3 image() const { return {-2 - lamp.x(), lamp.y(), lamp.z()}; }

    SceneDescription scene() const {
        const Vec3 mirroredTarget(-2 - target.x(), target.y(), target.z());
        SceneDescription scene;
        scene.objects = {floorOf(floor), standingMirror(mirror, {0, 10}, 10)};
        scene.lights = {
            std::make_shared<ConeLight>(lamp, mirroredTarget - lamp, halfAngle, Color::Constant(intensity))};
        return scene;
    }
};

// A caustic: the whole spot lies in one pixel, so its radiance is ρ/π of the cone's power over the pixel's area.
Case causticByMirror(Random& random) {
    const MirroredSpot spot(random);
    Case one = {spot.scene(), 0, 0, 64};
    one.scene.camera = pixelAt(spot.target + Vec3(0, 0, 3), spot.target, 0.5);
    const Real power = 2 * pi * (1 - std::cos(spot.halfAngle)) * spot.intensity;
    one.truth = spot.floor / pi * spot.mirror * power / 9;
    one.tolerance = 0.01 * one.truth;
    return one;
}

// The same spot seen in the mirror: specular, diffuse, specular.
Case causticInMirror(Random& random) {
    const MirroredSpot spot(random);
    Case one = {spot.scene(), 0, 0, 64};
    const Vec3 seen(-2 - spot.target.x(), spot.target.y(), 0);
    one.scene.camera = pixelAt({0.4, random.uniform(-0.3, 0.3), random.uniform(1.6, 2.5)}, seen, 1e-4);
    const Vec3 way = spot.target - spot.image();
    one.truth = spot.mirror * spot.mirror * spot.floor / pi * spot.intensity * spot.lamp.z() / std::pow(way.norm(), 3);
    one.tolerance = 0.5 * one.truth;
    return one;
}

// A floor under a lamp, seen in a small mirror that the lamp doesn't light.
Case seenInMirror(Random& random) {
    const Real floor = random.uniform(0.3, 0.9);
    const Real mirror = random.uniform(0.3, 1);
    const Real intensity = random.uniform(1, 10);
    const Vec3 target(random.uniform(0, 1), random.uniform(-0.5, 0.5), 0);
    const Vec3 lamp = target + Vec3(random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2), random.uniform(1, 2));
    const Vec3 eye(random.uniform(1, 2), random.uniform(-0.5, 0.5), random.uniform(1, 2));
    const Vec3 image(-2 - target.x(), target.y(), 0);
    const Vec3 at = eye + (-1 - eye.x()) / (image.x() - eye.x()) * (image - eye);
    Case one = {{}, 0, 0, 64};
    one.scene.objects = {floorOf(floor), standingMirror(mirror, {at.y(), at.z()}, 0.05)};
    one.scene.lights = {std::make_shared<ConeLight>(lamp, -Vec3::UnitZ(), 0.35, Color::Constant(intensity))};
    one.scene.camera = pixelAt(eye, image, 1e-4);
    one.truth = mirror * floor / pi * intensity * lamp.z() / std::pow((lamp - target).norm(), 3);
    one.tolerance = 0.01 * one.truth;
    return one;
}

// A point of the floor close to a wall that shines: a corner, where the geometry term has no bound. The wall's share of
// the point's hemisphere in closed form. Source: Howell, A Catalog of Radiation Heat Transfer Configuration Factors,
// B-4.
Case corner(Random& random) {
    const Real floor = random.uniform(0.3, 0.9);
    const Real radiance = random.uniform(1, 10);
    const Real distance = std::pow(10, random.uniform(-3, -1.5));
    const auto half = [distance](Real width, Real height) {
        const Real far = std::hypot(height, distance);
        return (std::atan(width / distance) - distance / far * std::atan(width / far)) / (2 * pi);
    };
    Case one = {{}, 0, 0, 256};
    one.scene.objects = {floorOf(floor), rectangleLamp({0, -1, 0}, {0, 2, 0}, {0, 0, 1}, Color::Constant(radiance))};
    one.scene.camera = pixelAt({2, 0, 1.5}, {distance, 0, 0}, 1e-5);
    one.truth = floor * radiance * 2 * half(1, 1);
    one.tolerance = 0.4 * one.truth;  // by chance half of the paths hit the wall: six standard errors of 256
    return one;
}

// A point lamp. Fragile: weighs it as if a path could hit it by chance.
Case pointLamp(Random& random) {
    const Real floor = random.uniform(0.3, 0.9);
    const Real intensity = random.uniform(1, 10);
    const Vec3 lamp(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(1, 3));
    Case one = {{}, 0, 0, 16};
    one.scene.objects = {floorOf(floor)};
    one.scene.lights = {std::make_shared<PointLight>(lamp, Color::Constant(intensity))};
    one.scene.camera = pixelAt({2, 0, 1.5}, Vec3::Zero(), 1e-4);
    const Real cosine = lamp.z() / lamp.norm();
    one.truth = floor / pi * intensity * cosine / lamp.squaredNorm();
    one.tolerance = 0.01 * one.truth;
    const Real byChance = cosine / pi;
    one.naive = one.truth / (1 + byChance * byChance);
    return one;
}

// A lamp seen in a mirror. Fragile: weighs the delta lobe's probability, 1, as a density.
Case lampInMirror(Random& random) {
    const Real mirror = random.uniform(0.3, 1);
    const Real radiance = random.uniform(1, 10);
    const Real side = random.uniform(0.5, 1.5);
    const Vec3 eye(random.uniform(1, 2), 0, 1);
    const Real distance = random.uniform(1, 2);  // of the lamp from the mirror
    Case one = {{}, 0, 0, 16};
    one.scene.objects = {
        standingMirror(mirror, {0, 1}, 2),
        // Beside the eye, facing the mirror.
        rectangleLamp({distance - 1, 1, 1 - side / 2}, {0, 0, side}, {0, side, 0}, Color::Constant(radiance))};
    const Vec3 middle(-1 - distance, 1 + side / 2, 1);
    one.scene.camera = pixelAt(eye, middle, 1e-4);
    one.truth = mirror * radiance;
    one.tolerance = 1e-6 * one.truth;
    const Vec3 at = eye + (-1 - eye.x()) / (middle.x() - eye.x()) * (middle - eye);
    const Vec3 way = middle - at;
    const Real asked = way.squaredNorm() / (side * side * std::abs(way.x()) / way.norm());
    one.naive = one.truth / (1 + asked * asked);
    return one;
}

// A kind of case. `naive` is what its fragile method is called if it has one of its own; the others are the chapter's.
FailureKind kind(const std::string& name, Case (*make)(Random&), const std::string& naive,
                 const std::vector<Method>& fragile, const std::vector<Method>& robust) {
    FailureKind made = {name, {}, nullptr};
    if (!naive.empty()) made.methods.push_back({naive});
    for (const Method method : fragile) made.methods.push_back({nameOf(method)});
    for (const Method method : robust) made.methods.push_back({nameOf(method), true});
    std::vector<Method> methods = fragile;
    methods.insert(methods.end(), robust.begin(), robust.end());
    made.right = [make, methods](Random& random) {
        const Case one = make(random);
        std::vector<bool> right;
        if (one.naive) right = within(one.tolerance, one.truth, {*one.naive});
        const std::uint64_t seed = random.below(std::uint64_t{1} << 32);
        for (const Method method : methods)
            right.push_back(std::abs(rendered(method, one, seed) - one.truth) <= one.tolerance);
        return right;
    };
    return made;
}

}  // namespace

std::vector<FailureRow> failureRows(const FailureTrials& trials) {
    const std::vector<Method> robust = {Method::Mis, Method::Bidirectional};
    return countFailures(
        {kind("caustic: a spot of light from a point lamp by a mirror", causticByMirror, "",
              {Method::Chance, Method::Direct, Method::Mis}, {Method::Light, Method::Bidirectional}),
         kind("mirror: a lit floor seen in it", seenInMirror, "", {Method::Light}, robust),
         kind("specular–diffuse–specular: such a spot seen in a mirror", causticInMirror, "",
              {Method::Mis, Method::Light, Method::Bidirectional}, {}),
         kind("corner: a floor within millimetres of a wall that shines", corner, "", {Method::Direct}, robust),
         kind("delta light: a floor under a point lamp", pointLamp, "weight as if a point could be hit", {}, robust),
         kind("delta material: a lamp seen in a mirror", lampInMirror, "weight as if a mirror had a density", {},
              robust)},
        trials);
}

void chartFailures(FigureContext& context) {
    drawFailureBars(failureRows(FailureTrials::of(context, context.byQuality(200, 2000))), context);
}

}  // namespace caustic
