#include "integrator/direct_at_point.h"

#include "integrator/direct_light.h"
#include "integrator/power_heuristic.h"
#include "integrator/scatter.h"

namespace caustic {

namespace {

// Of the lamp that a sampled direction meets.
Color metByChance(const Scene& scene, const LightChoice& lights, const VisiblePoint& point, const PathNumbers& numbers,
                  RayCounts& counts) {
    const Interaction& at = point.at;
    const auto next = scatter(at, TransportMode::Radiance, numbers, point.length - 1);
    if (!next) return Color::Zero();
    const Vec3& wi = next->sample.wi;
    // Veach 1997, eq. 9.13 with β = 2.
    const auto weight = [&](const Light& light, Real pdfW) {
        return next->sample.delta() ? 1 : powerHeuristic(next->sample.pdfW, lights.probability(light) * pdfW);
    };
    const Ray ray = at.spawn(wi);
    MediumStack media = at.media(wi);
    Color passed;
    const auto lamp = scene.follow(ray, media, passed, numbers, point.length, counts);
    Color sum = Color::Zero();
    if (lamp && lamp->light() != nullptr) {
        sum = lamp->Le() * weight(*lamp->light(), lamp->light()->pdfW(at.point(), lamp->hit()));
    } else if (!lamp) {
        for (const ChosenLight& one : lights.infinite())
            sum += one.light->Le(ray) * weight(*one.light, one.light->pdfW(at.point(), wi));
    }
    return next->weight * passed * sum;
}

}  // namespace

Color directAtPoint(const Scene& scene, const LightChoice& lights, const VisiblePoint& point,
                    const PathNumbers& numbers, RayCounts& counts) {
    const Interaction& at = point.at;
    const bool glossy = at.isSurface() && anyOf(at.bsdf()->lobes(), LobeFlags::Glossy);
    Color sum = glossy ? metByChance(scene, lights, point, numbers, counts) : Color::Zero();
    const auto direct = sampleDirectLight(scene, lights, at, point.length - 1, numbers, counts);
    if (!direct) return sum;
    const bool alone = !glossy || direct->light.light->deltaPlace();
    // Veach 1997, eq. 9.13 with β = 2.
    const Real weight = alone ? 1 : powerHeuristic(direct->pdfW, at.pdfW(direct->sample.wi));
    return sum + direct->value * weight;
}

}  // namespace caustic
