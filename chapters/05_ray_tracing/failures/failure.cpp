#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "camera/box_filter.h"
#include "figures.h"
#include "integrator/ray_tracer.h"
#include "light/constant_environment.h"
#include "material/directions.h"
#include "material/refraction_bsdf.h"
#include "material/refraction_material.h"
#include "medium/absorbing_medium.h"
#include "sampling/independent_sampler.h"
#include "shape/box.h"
#include "shape/sphere.h"
#include "slab.h"
#include "soft_shadow.h"

namespace caustic {

namespace {

Color traced(const Scene& scene, const Ray& ray, const RayTracerSettings& settings) {
    const IndependentSampler sampler(1);
    const BoxFilter filter;
    const RayTracer tracer(scene, sampler, filter, settings);
    RayCounts counts;
    return tracer.Li(ray, scene.mediaAt(ray.origin), sampler.start(0, {0, 0}, 0), counts);
}

// Inside glass, more aslant than the critical angle: all light stays inside. Fragile: what Snell's law has no answer
// for is black.
std::vector<bool> totalReflection(Random& random) {
    const Real ior = random.uniform(1.1, 2.5);
    const Real sine = random.uniform(1.0001 / ior, 1);
    const Vec3 wo(sine, 0, -std::sqrt(1 - sine * sine));  // below the surface
    ShadingFrame shading;
    shading.iorBelow = ior;
    const RefractionBsdf glass(shading, Color::Zero(), Color::Ones());
    Real energy = 0;
    for (const BsdfSample& lobe : glass.deltaLobes(wo, TransportMode::Radiance))
        energy += lobe.f.x() * lobe.eta * lobe.eta;
    const auto through = refracted({sine, 0, -wo.z()}, Vec3::UnitZ(), 1 / ior);
    return within(1e-12, 1, {through ? 1.0 : 0.0, energy});
}

// Through an absorbing ball: the way inside is a chord by Snell's law. Fragile: absorbs where the surface is seen from
// outside.
std::vector<bool> absorption(Random& random) {
    const Real ior = random.uniform(1.1, 2);
    const Real sigma = random.uniform(0.1, 3);
    const Real offset = random.uniform(0, 0.99);
    const SceneObject ball = {.shape = std::make_shared<Sphere>(Vec3::Zero(), 1.0),
                              .material = std::make_shared<RefractionMaterial>(Color::Zero(), Color::Ones()),
                              .interior = Interior{ior, std::make_shared<AbsorbingMedium>(Color::Constant(sigma)), 0}};
    const Scene scene({.objects = {ball}, .lights = {std::make_shared<ConstantEnvironment>(Color::Ones())}});
    const Real sine = offset / ior;
    const Real chord = 2 * std::sqrt(1 - sine * sine);
    const Real before = 3 - std::sqrt(1 - offset * offset);
    return within(1e-9, std::exp(-sigma * chord),
                  {std::exp(-sigma * before), traced(scene, {Vec3(-3, offset, 0), Vec3::UnitX()}, {}).x()});
}

// Two panes of index 1 that overlap, the second within the first or beyond it; colours by interval arithmetic.
struct Overlap {
    Real from[2];
    Real to[2];
    Real sigma[2];
    int priority[2];

    // Optical thickness along x, by which pane fills each piece. Fragile: the one whose boundary was crossed last.
    Real thickness(bool lastCrossed) const {
        std::vector<Real> borders = {from[0], to[0], from[1], to[1]};
        std::sort(borders.begin(), borders.end());
        Real sum = 0;
        int current = -1;  // of the fragile method
        for (std::size_t i = 0; i + 1 < borders.size(); ++i) {
            for (int k = 0; k < 2; ++k) {
                if (borders[i] == from[k]) current = k;
                if (borders[i] == to[k]) current = -1;
            }
            const Real middle = (borders[i] + borders[i + 1]) / 2;
            const bool in0 = middle > from[0] && middle < to[0];
            const bool in1 = middle > from[1] && middle < to[1];
            const int top = in0 && in1 ? (priority[0] > priority[1] ? 0 : 1) : in0 ? 0 : in1 ? 1 : -1;
            const int filling = lastCrossed ? current : top;
            if (filling >= 0) sum += sigma[filling] * (borders[i + 1] - borders[i]);
        }
        return sum;
    }
};

std::vector<bool> nestedGlass(Random& random) {
    Overlap panes;
    SceneDescription description;
    for (int k = 0; k < 2; ++k) {
        panes.from[k] = random.uniform(0, 1);
        panes.to[k] = random.uniform(1.1, 2);  // both hold x = 1.05
        panes.sigma[k] = random.uniform(0.5, 2);
        panes.priority[k] = random.below(2) == 0 ? k : 3 * (1 - k) + 1;
        description.objects.push_back(
            {.shape = std::make_shared<Box>(Vec3(panes.from[k], -9, -9), Vec3(panes.to[k], 9, 9)),
             .material = std::make_shared<RefractionMaterial>(Color::Zero(), Color::Ones()),
             .interior =
                 Interior{1, std::make_shared<AbsorbingMedium>(Color::Constant(panes.sigma[k])), panes.priority[k]}});
    }
    if (panes.priority[0] == panes.priority[1]) {
        ++panes.priority[1];
        ++description.objects[1].interior->priority;
    }
    description.lights = {std::make_shared<ConstantEnvironment>(Color::Ones())};
    const Scene scene(description);
    return within(1e-9, std::exp(-panes.thickness(false)),
                  {std::exp(-panes.thickness(true)), traced(scene, {Vec3(-1, 0, 0), Vec3::UnitX()}, {}).x()});
}

// A pane that reflects much: four reflections aren't enough. Right within 1 %.
std::vector<bool> depthCutOff(Random& random) {
    const Real reflectance = random.uniform(0.3, 0.95);
    const Real sigma = random.uniform(0, 0.3);
    const Scene scene(slabScene(reflectance, sigma));
    const Ray ray = {Vec3(-1, 0, 0), Vec3::UnitX()};
    const Real truth = slabTransmission(reflectance, sigma);
    return within(
        0.01 * truth, truth,
        {traced(scene, ray, {.maxDepth = 4}).x(), traced(scene, ray, {.maxDepth = 1000, .leastWeight = 1e-5}).x()});
}

// A point of the floor that a plate hides from some of the lamp. Fragile: asks the middle of the lamp only, so that the
// penumbra has a hard edge. Right within 0.04 of the lamp's whole light, which 400 stratified samples stay within.
std::vector<bool> penumbra(Random& random, const Scene& scene) {
    const Real x = random.uniform(-1.4, 1.4);
    const Real z = random.uniform(-1.4, 1.4);
    const Ray ray = {Vec3(x, 0.5, z), -Vec3::UnitY()};
    const Real truth = softShadow(x, z);
    const bool hidden = std::max(std::abs(x), std::abs(z)) < 1;  // twice the plate, seen from the lamp's middle
    const Real distance = 4 + x * x + z * z;
    const Real middle = hidden ? 0 : 4 * 4 / (std::numbers::pi * distance * distance);
    return within(0.04, truth, {middle, traced(scene, ray, {.maxDepth = 0, .shadowSamples = 400}).x()});
}

}  // namespace

std::vector<FailureRow> failureRows(const FailureTrials& trials) {
    const Scene scene(softShadowScene());
    return countFailures(
        {{"glass: beyond the critical angle",
          {{"no refraction is black"}, {"total reflection", true}},
          totalReflection},
         {"glass ball: colour of a ray through it", {{"absorption outside"}, {"absorption inside", true}}, absorption},
         {"two overlapping panes: what is between", {{"last boundary crossed"}, {"priorities", true}}, nestedGlass},
         {"reflecting pane: light lost by the cut-off", {{"depth 4"}, {"weight 1e-5", true}}, depthCutOff},
         {"penumbra: light of a half hidden lamp",
          {{"centre of the lamp"}, {"points all over the lamp", true}},
          [&](Random& random) { return penumbra(random, scene); }}},
        trials);
}

void chartFailures(FigureContext& context) { drawFailureBars(failureRows(FailureTrials::of(context, 2000)), context); }

}  // namespace caustic
