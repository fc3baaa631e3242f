#include "failures/volume_failures.h"

#include <cmath>
#include <limits>
#include <numbers>

#include "camera/box_filter.h"
#include "integrator/medium_light.h"
#include "integrator/path_tracer.h"
#include "integrator/photon_volume.h"
#include "measures/air_light.h"
#include "medium/henyey_greenstein.h"
#include "medium/homogeneous_medium.h"
#include "sampling/independent_sampler.h"
#include "shape/sphere.h"

namespace caustic {

namespace {

Vec3 direction(Random& random) {
    const Real z = random.uniform(-1, 1);
    const Real angle = random.uniform(0, 2 * std::numbers::pi);
    const Real across = std::sqrt(1 - z * z);
    return {across * std::cos(angle), across * std::sin(angle), z};
}

// All three channels within a share of the truth.
bool close(const Color& found, const Color& truth, Real share) {
    return ((found - truth).abs() <= share * truth).all();
}

Color randomColor(Random& random, Real most) {
    const Real red = random.uniform(0, most);
    const Real green = random.uniform(0, most);
    return {red, green, random.uniform(0, most)};
}

AirLight randomAirLight(Random& random) {
    AirLight light;
    light.sigmaA = randomColor(random, 0.1);
    light.sigmaS = randomColor(random, 0.3);
    light.g = random.uniform(-0.7, 0.7);
    light.lamp = random.uniform(0, 1.5) * direction(random);
    light.eye = 2.5 * direction(random);
    return light;
}

// Light around a lamp, along a ray that misses it by a share of the distance: marching by 64 steps, 64 free flights, 64
// places around the lamp. Right is what is within a tenth.
std::vector<bool> besideTheLamp(Random& random, Real least, Real most) {
    const AirLight light = randomAirLight(random);
    const Vec3 way = (light.lamp - light.eye).normalized();
    const Vec3 across = way.cross(direction(random)).normalized();
    const Vec3 aim = (way + across * random.uniform(least, most)).normalized();
    const Scene scene(light.scene(1, 1));
    const LightChoice lights(scene.lights());
    RayCounts counts;
    std::vector<MediumSpan> spans;
    MediumStack media = scene.cameraMedia();
    Color passed;
    const Ray ray = {light.eye, aim};
    scene.follow(ray, media, passed, spans, counts);
    const IndependentSampler sampler(random.below(1 << 30));
    const PathNumbers numbers = sampler.start(0, {0, 0}, 0);
    constexpr int places = 64;
    const Color marched = scatteredByMarching(scene, lights, spans.front(), places, 0, numbers, counts);
    const BoxFilter filter;
    const PathTracer tracer(scene, sampler, filter, {{.maxLength = 2, .rouletteStart = 9}, Direct::Mis});
    Color flown = Color::Zero();
    const Color around = scatteredEquiAngular(scene, lights, spans.front(), places, 0, numbers, counts);
    for (int i = 0; i < places; ++i)
        flown += tracer.Li(ray, scene.cameraMedia(), sampler.start(1, {0, 0}, i), counts) / places;
    const Color truth = light.scatteredOnce(aim);
    return {close(marched, truth, 0.1), close(flown, truth, 0.1), close(around, truth, 0.1)};
}

// Photons of one kind, evenly in a ball of thin fog, and a ray through it: the answer is known. A large disc reaches
// beyond the fog, a small one holds too few.
std::vector<bool> radii(Random& random) {
    constexpr int count = 20'000;
    std::vector<Photon> photons;
    while (photons.size() < count) {
        const Vec3 point(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
        if (point.norm() > 1) continue;
        Photon photon;
        photon.point = point;
        photon.power = Color::Ones() / count;
        photon.length = 2;
        photon.way = PhotonWay::Indirect;
        photons.push_back(photon);
    }
    const HomogeneousMedium fog(Color::Zero(), Color::Constant(1e-9), std::make_shared<HenyeyGreenstein>(0));
    const Vec3 towards = direction(random);
    const Vec3 beside = towards.cross(direction(random)).normalized() * random.uniform(0, 0.9);
    const Real half = std::sqrt(1 - beside.squaredNorm());
    const MediumSpan span = {{beside - half * towards, towards}, 2 * half, &fog, {}, Color::Ones()};
    const Real density = 1 / (4.0 / 3 * std::numbers::pi);
    const Color truth = Color::Constant(density / (4 * std::numbers::pi) * 2 * half);
    const PhotonVolume volume(photons);
    std::vector<bool> right;
    for (const Real radius : {0.6, 0.02, 0.15})
        right.push_back(close(volume.radiance(span, {radius, 9, 1, true}), truth, 0.15));
    return right;
}

// The textbook's distance and transmittance, which divide by σ and multiply it by an infinite way.
Color textbookPassed(const Color& sigma, Real distance) { return (-sigma * distance).exp(); }

// A medium one of whose colours nothing stops, or none at all, and a way without an end.
std::vector<bool> clearChannel(Random& random) {
    Color sigma = randomColor(random, 2);
    sigma[static_cast<int>(random.below(3))] = 0;
    const HomogeneousMedium medium(sigma, Color::Zero(), std::make_shared<HenyeyGreenstein>(0));
    const Real infinity = std::numeric_limits<Real>::infinity();
    const Ray ray = {Vec3::Zero(), direction(random)};
    const auto right = [&](const Color& passed) { return passed.isFinite().all() && passed.maxCoeff() == 1; };
    return {right(textbookPassed(sigma, infinity)), right(medium.transmittance(ray, infinity))};
}

// An eye in fog that looks at the sky. Fragile: it is taken to be in empty space until it meets a boundary.
std::vector<bool> eyeWithin(Random& random) {
    AirLight light = randomAirLight(random);
    light.eye = random.uniform(0, 2.9) * direction(random);
    light.lamp = light.eye + direction(random);
    const Scene scene(light.scene(1, 1));
    const Vec3 towards = direction(random);
    const Real middle = -light.eye.dot(towards);
    const Real way = middle + std::sqrt(light.size * light.size - (light.eye + middle * towards).squaredNorm());
    const Color truth = (-(light.sigmaA + light.sigmaS) * way).exp();
    std::vector<bool> right;
    for (MediumStack media : {MediumStack(), scene.cameraMedia()}) {
        RayCounts counts;
        Color passed;
        scene.follow({light.eye, towards}, media, passed, counts);
        right.push_back(close(passed, truth, 1e-9));
    }
    return right;
}

// A medium of density 0 around a room: the same light as without, bit for bit.
std::vector<bool> densityZero(Random& random) {
    AirLight light = randomAirLight(random);
    const Scene with([&] {
        AirLight none = light;
        none.sigmaA = Color::Zero();
        none.sigmaS = Color::Zero();
        return none.scene(1, 1);
    }());
    SceneDescription empty = light.scene(1, 1);
    empty.objects.front().interior->medium = nullptr;
    const Scene without(std::move(empty));
    const IndependentSampler sampler(random.below(1 << 30));
    const BoxFilter filter;
    std::vector<Splat> splats;
    RayCounts counts;
    const auto traced = [&](const Scene& scene) {
        return PathTracer(scene, sampler, filter, {}).tracePath({{0, 0}, 0}, splats, counts);
    };
    return {(traced(with) == traced(without)).all() && !with.needs().scattering};
}

}  // namespace

std::vector<FailureKind> volumeKinds() {
    const std::vector<TriedMethod> lamp = {
        {"64 steps of marching"}, {"64 free flights"}, {"64 equi-angular places", true}};
    return {{"fog: past a lamp", lamp, [](Random& random) { return besideTheLamp(random, 0.1, 0.5); }},
            {"fog: light near the ray", lamp, [](Random& random) { return besideTheLamp(random, 0.001, 0.02); }},
            {"fog: radius of photons", {{"radius 0.6"}, {"radius 0.02"}, {"radius 0.15"}}, radii},
            {"fog: a clear channel", {{"textbook's transmittance"}, {"HomogeneousMedium", true}}, clearChannel},
            {"fog: eye within", {{"as if in empty space"}, {"scene's media", true}}, eyeWithin},
            {"fog: density 0", {{"HomogeneousMedium", true}}, densityZero}};
}

}  // namespace caustic
