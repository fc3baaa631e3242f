#include "figures/glossy_tracer.h"

namespace caustic {

Color GlossyTracer::Li(const Ray& ray, const MediumStack& media, const PathNumbers& numbers, RayCounts& counts) const {
    Color sum = Color::Zero();
    Color beta = Color::Ones();
    Ray rest = ray;
    MediumStack here = media;
    for (int vertex = 0; vertex < maxDepth_; ++vertex) {
        Color transmittance;
        const std::optional<Interaction> at = scene().follow(rest, here, transmittance, counts);
        beta *= transmittance;
        if (!at) return sum + beta * scene().Le(rest);
        sum += beta * at->Le();
        if (at->bsdf() == nullptr) return sum;
        if (anyOf(at->bsdf()->lobes(), LobeFlags::Diffuse))
            return sum + beta * atDiffuse_.direct(*at, vertex, numbers, counts);

        const auto sample =
            at->sample(numbers.pair(Dimension::vertex(vertex, VertexUse::Direction)),
                       numbers.number(Dimension::vertex(vertex, VertexUse::Lobe)), TransportMode::Radiance);
        if (!sample) return sum;
        beta *= sample->f * (sample->delta() ? 1 : at->cosine(sample->wi)) / sample->pdfW;
        rest = at->spawn(sample->wi);
        here = at->media(sample->wi);
    }
    return sum;
}

}  // namespace caustic
