#include "integrator/path_tracer.h"

#include "core/not_implemented.h"
#include "integrator/power_heuristic.h"
#include "integrator/walk.h"

namespace caustic {

namespace {

constexpr LobeFlags spread = LobeFlags::Diffuse | LobeFlags::Glossy;

}  // namespace

// Gathers what a walk from the eye finds.
class PathTracer::Visitor {
public:
    Visitor(const PathTracer& tracer, const PathNumbers& numbers, RayCounts& counts)
        : tracer_(tracer), numbers_(numbers), counts_(counts) {}

    bool reached(const Interaction& at, const WalkState& path) {
        if (const Light* const light = at.light()) {
            const Color Le = at.Le();
            if ((Le > 0).any()) {
                const Real pdfW = arrival_.counts ? 0 : light->pdfW(arrival_.from, at.hit());
                sum_ += path.beta * Le * tracer_.chanceWeight(arrival_, *light, pdfW);
            }
        }
        if (at.bsdf() == nullptr || path.length >= tracer_.settings_.limits.maxLength) return false;
        if (tracer_.settings_.direct != Direct::ByChance && anyOf(at.bsdf()->lobes(), spread))
            sum_ += path.beta * tracer_.direct(at, path.length - 1, numbers_, counts_);
        return true;
    }

    void scattered(const Interaction& at, const BsdfSample& sample) {
        arrival_ = {sample.delta(), at.hit().point, sample.pdfW};
    }

    void escaped(const WalkState& path) {
        for (const ChosenLight& one : tracer_.lights_.infinite()) {
            const Real pdfW = arrival_.counts ? 0 : one.light->pdfW(arrival_.from, path.ray.direction);
            sum_ += path.beta * one.light->Le(path.ray) * tracer_.chanceWeight(arrival_, *one.light, pdfW);
        }
    }

    const Color& sum() const { return sum_; }

private:
    const PathTracer& tracer_;
    const PathNumbers& numbers_;
    RayCounts& counts_;
    Arrival arrival_;
    Color sum_ = Color::Zero();
};

PathTracer::PathTracer(const Scene& scene, const Sampler& sampler, const PixelFilter& filter,
                       const PathTracerSettings& settings)
    : Integrator(scene, sampler, filter), settings_(settings), lights_(scene.lights()) {
    checkLimits(settings.limits);
}

Color PathTracer::Li(const Ray& ray, const MediumStack& media, const PathNumbers& numbers, RayCounts& counts) const {
    Visitor visitor(*this, numbers, counts);
    walk(scene(), {ray, media, Color::Ones()}, TransportMode::Radiance, settings_.limits, numbers, counts, visitor);
    return visitor.sum();
}

Color PathTracer::direct(const Interaction& at, int vertex, const PathNumbers& numbers, RayCounts& counts) const {
    //! [ex-07.3]
    const auto chosen = lights_.choose(numbers.number(Dimension::vertex(vertex, VertexUse::LightChoice)));
    if (!chosen) return Color::Zero();
    const Vec2 u = numbers.pair(Dimension::vertex(vertex, VertexUse::LightPoint));
    const auto sample = chosen->light->sampleDirect(at.hit(), u);
    if (!sample) return Color::Zero();
    const Color f = at.bsdf()->f(at.wo(), sample->wi, TransportMode::Radiance);
    if ((f == 0).all()) return Color::Zero();
    const Color passed = scene().transmittance(sample->ray, at.media(sample->wi), counts);

    const Real pdfW = chosen->probability * sample->pdfW;
    const bool byChanceToo = settings_.direct == Direct::Mis && !chosen->light->deltaPlace();
    const Real weight = byChanceToo ? powerHeuristic(pdfW, at.bsdf()->pdfW(at.wo(), sample->wi)) : 1;
    return weight * f * at.bsdf()->cosine(sample->wi) * sample->radiance * passed / pdfW;
    //! [ex-07.3]
}

Real PathTracer::chanceWeight(const Arrival& arrival, const Light& found, Real pdfW) const {
    //! [ex-07.4]
    if (arrival.counts || settings_.direct == Direct::ByChance) return 1;
    if (settings_.direct == Direct::DirectLight) return 0;
    return powerHeuristic(arrival.pdfW, lights_.probability(found) * pdfW);
    //! [ex-07.4]
}

}  // namespace caustic
