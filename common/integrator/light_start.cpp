#include "integrator/light_start.h"

#include <cmath>

namespace caustic {

std::optional<LightStart> startAtLight(const Scene& scene, const LightChoice& lights, const PathNumbers& numbers) {
    const auto light = lights.choose(numbers.number(Dimension::vertex(0, VertexUse::LightChoice)));
    if (!light) return std::nullopt;
    const auto emission = light->light->sampleEmission(numbers.pair(Dimension::emissionPoint()),
                                                       numbers.pair(Dimension::emissionDirection()));
    if (!emission) return std::nullopt;
    LightStart start = {*light, *emission, Color::Zero(), {}};
    const Real cosine = std::abs(emission->ng.dot(emission->ray.direction));
    // Veach 1997, 10.2: the first factor of a light path's α.
    start.beta = emission->radiance * cosine / (light->probability * emission->pdfA * emission->pdfW);
    if (scene.needs().interiors) start.media = scene.mediaAt(emission->ray.origin);
    return start;
}

}  // namespace caustic
