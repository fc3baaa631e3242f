#include "integrator/direct_light.h"

#include "core/not_implemented.h"

namespace caustic {

std::optional<DirectLight> askForLight(const Scene& scene, const LightChoice& lights, const Interaction& at, int vertex,
                                       const PathNumbers& numbers, RayCounts& counts) {
    //! [ex-07.3]
    const auto chosen = lights.choose(numbers.number(Dimension::vertex(vertex, VertexUse::LightChoice)));
    if (!chosen) return std::nullopt;
    const Vec2 u = numbers.pair(Dimension::vertex(vertex, VertexUse::LightPoint));
    const auto sample = chosen->light->sampleDirect(at.hit(), u);
    if (!sample) return std::nullopt;
    const Color f = at.bsdf()->f(at.wo(), sample->wi, TransportMode::Radiance);
    if ((f == 0).all()) return std::nullopt;
    const Color passed = scene.transmittance(sample->ray, at.media(sample->wi), counts);
    if ((passed == 0).all()) return std::nullopt;
    const Real pdfW = chosen->probability * sample->pdfW;
    const Color value = f * at.bsdf()->cosine(sample->wi) * sample->radiance * passed / pdfW;
    return DirectLight{*chosen, u, *sample, pdfW, value};
    //! [ex-07.3]
}

}  // namespace caustic
