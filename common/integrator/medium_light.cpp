#include "integrator/medium_light.h"

#include <cmath>

#include "core/check.h"
#include "integrator/direct_light.h"
#include "medium/equi_angular.h"

namespace caustic {

namespace {

// Light of a lamp that comes to a place of the piece and is turned to where it begins, 1/m of what σ_s counts apart.
Color turnedAt(const Scene& scene, const LightChoice& lights, const MediumSpan& span, Real t, int vertex,
               const PathNumbers& numbers, RayCounts& counts) {
    const Interaction at(span.ray.at(t), -span.ray.direction, *span.medium->phase(), span.media);
    const auto direct = sampleDirectLight(scene, lights, at, vertex, numbers, counts);
    return direct ? direct->value : Color::Zero();
}

}  // namespace

Color scatteredEquiAngular(const Scene& scene, const LightChoice& lights, const MediumSpan& span, int places,
                           int vertex, const PathNumbers& numbers, RayCounts& counts) {
    //! [equi-angular]
    const Real offset = numbers.number(Dimension::vertex(vertex, VertexUse::Distance));
    Color sum = Color::Zero();
    for (int i = 0; i < places; ++i) {
        const Real u = (i + offset) / places;
        const PathNumbers own = numbers.part(i, places);
        const auto lamp = lights.choose(own.number(Dimension::vertex(vertex, VertexUse::LightChoice)));
        if (!lamp) return Color::Zero();
        if (lamp->light->infinite()) {
            const Real uChannel = own.number(Dimension::vertex(vertex, VertexUse::Channel));
            const DistanceSample sample = span.medium->sampleDistance(span.ray, span.tEnd, u, uChannel);
            if (sample.scattered) sum += sample.weight * turnedAt(scene, lights, span, sample.t, vertex, own, counts);
            continue;
        }
        // The point of the lamp that sampleDirectLight will pick by the same numbers, wherever it is asked from.
        const Vec2 uPoint = own.pair(Dimension::vertex(vertex, VertexUse::LightPoint));
        const auto emission = lamp->light->sampleEmission(uPoint, {0.5, 0.5});
        if (!emission) continue;
        const PlaceOnRay place = sampleEquiAngular(span.ray, span.tEnd, emission->ray.origin, u);
        const Color weight =
            span.medium->sigmaS(span.ray.at(place.t)) * span.medium->transmittance(span.ray, place.t) / place.pdf;
        sum += weight * turnedAt(scene, lights, span, place.t, vertex, own, counts);
    }
    return sum / places;
    //! [equi-angular]
}

Color scatteredByMarching(const Scene& scene, const LightChoice& lights, const MediumSpan& span, int steps, int vertex,
                          const PathNumbers& numbers, RayCounts& counts) {
    checkArgument(std::isfinite(span.tEnd), "ray marching", formatReal(span.tEnd), "needs a medium that ends");
    Color sum = Color::Zero();
    const Real step = span.tEnd / steps;
    for (int i = 0; i < steps; ++i) {
        const Real t = (i + 0.5) * step;
        const PathNumbers own = numbers.part(i, steps);
        sum += span.medium->sigmaS(span.ray.at(t)) * span.medium->transmittance(span.ray, t) *
               turnedAt(scene, lights, span, t, vertex, own, counts);
    }
    return sum * step;
}

}  // namespace caustic
