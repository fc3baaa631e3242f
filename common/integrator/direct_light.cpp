#include "integrator/direct_light.h"

#include "core/not_implemented.h"

namespace caustic {

std::optional<DirectLight> sampleDirectLight(const Scene& scene, const LightChoice& lights, const Interaction& at,
                                             int vertex, const PathNumbers& numbers, RayCounts& counts) {
    //! [ex-07.3]
    const auto chosen = lights.choose(numbers.number(Dimension::vertex(vertex, VertexUse::LightChoice)));
    if (!chosen) return std::nullopt;
    const Vec2 u = numbers.pair(Dimension::vertex(vertex, VertexUse::LightPoint));
    const auto sample = chosen->light->sampleDirect(at.place(), u);
    if (!sample) return std::nullopt;
    const Color f = at.f(sample->wi, TransportMode::Radiance);
    if ((f == 0).all()) return std::nullopt;
    const Color passed = scene.transmittance(sample->ray, at.media(sample->wi), counts);
    if ((passed == 0).all()) return std::nullopt;
    // Shirley, Wang, Zimmerman 1996, Monte Carlo Techniques for Direct Lighting Calculations: one of several lights.
    const Real pdfW = chosen->probability * sample->pdfW;
    const Color value = f * at.cosine(sample->wi) * sample->radiance * passed / pdfW;
    return DirectLight{*chosen, *sample, pdfW, value};
    //! [ex-07.3]
}

}  // namespace caustic
