#include "integrator/ray_tracer.h"

#include "core/check.h"
#include "core/not_implemented.h"

namespace caustic {

RayTracer::RayTracer(const Scene& scene, const Sampler& sampler, const PixelFilter& filter,
                     const RayTracerSettings& settings)
    : Integrator(scene, sampler, filter), settings_(settings) {
    checkArgument(settings.maxDepth >= 0, "recursion depth", std::to_string(settings.maxDepth), "must be at least 0");
    checkArgument(settings.shadowSamples >= 1, "shadow samples", std::to_string(settings.shadowSamples),
                  "must be at least 1");
    checkArgument(settings.leastWeight >= 0 && settings.leastWeight < 1, "least weight",
                  formatReal(settings.leastWeight), "must be at least 0 and less than 1");
}

Color RayTracer::Li(const Ray& ray, const MediumStack& media, const PathNumbers& numbers, RayCounts& counts) const {
    return trace({ray, media, 0, 1}, numbers, counts);
}

Color RayTracer::trace(const Branch& branch, const PathNumbers& numbers, RayCounts& counts) const {
    //! [ex-05.8]
    MediumStack media = branch.media;
    Color transmittance;
    const std::optional<Interaction> at = scene().follow(branch.ray, media, transmittance, counts);
    if (!at) return transmittance * scene().Le(branch.ray);
    Color sum = at->Le();
    if (at->bsdf() == nullptr) return transmittance * sum;

    sum += direct(*at, branch.depth, numbers, counts) + ambient(*at, branch.depth, numbers);
    if (branch.depth >= settings_.maxDepth) return transmittance * sum;
    std::uint64_t label = 0;
    for (const BsdfSample& lobe : at->bsdf()->deltaLobes(at->wo(), TransportMode::Radiance)) {
        // Energy, not radiance: what is scaled by 1/eta² on the way in is scaled back on the way out.
        const Real energy = (lobe.f * transmittance).maxCoeff() * lobe.eta * lobe.eta;
        const Branch next = {at->spawn(lobe.wi), at->media(lobe.wi), branch.depth + 1, branch.weight * energy};
        if (next.weight > settings_.leastWeight) sum += lobe.f * trace(next, numbers.branch(label), counts);
        ++label;
    }
    return transmittance * sum;
    //! [ex-05.8]
}

Color RayTracer::direct(const Interaction& at, int vertex, const PathNumbers& numbers, RayCounts& counts) const {
    //! [ex-05.7]
    Color sum = Color::Zero();
    if (!at.connectible()) return sum;
    std::uint64_t label = 0;
    for (const auto& light : scene().lights()) {
        const PathNumbers ofLight = numbers.branch(label++);
        const int samples = light->deltaPlace() ? 1 : settings_.shadowSamples;
        for (int i = 0; i < samples; ++i) {
            const Vec2 u = ofLight.part(i, samples).pair(Dimension::vertex(vertex, VertexUse::LightPoint));
            const auto sample = light->sampleDirect(at.place(), u);
            if (!sample) continue;
            const Color f = at.f(sample->wi, TransportMode::Radiance);
            if ((f == 0).all()) continue;
            const Color passed = scene().transmittance(sample->ray, at.media(sample->wi), counts);
            // Shirley, Wang, Zimmerman 1996, Monte Carlo Techniques for Direct Lighting Calculations:
            // ∫ f |cos| L dω, from points of the light.
            sum += f * at.cosine(sample->wi) * sample->radiance * passed / (sample->pdfW * samples);
        }
    }
    return sum;
    //! [ex-05.7]
}

// Light from everywhere, of which nothing is in the way: one sample of the BSDF, which is exact for a diffuse one.
Color RayTracer::ambient(const Interaction& at, int vertex, const PathNumbers& numbers) const {
    if (!scene().needs().ambient || !at.connectible()) return Color::Zero();
    const auto sample =
        at.bsdf()->sample(at.wo(), numbers.pair(Dimension::vertex(vertex, VertexUse::Direction)),
                          numbers.number(Dimension::vertex(vertex, VertexUse::Lobe)), TransportMode::Radiance);
    if (!sample || sample->delta()) return Color::Zero();
    // PBR, 4th ed., 2.1: the mean of what is integrated over its density.
    return sample->f * at.bsdf()->cosine(sample->wi) / sample->pdfW * scene().ambient();
}

}  // namespace caustic
