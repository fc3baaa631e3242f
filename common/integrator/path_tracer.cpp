#include "integrator/path_tracer.h"

#include "core/not_implemented.h"
#include "integrator/direct_light.h"
#include "integrator/power_heuristic.h"
#include "integrator/walk.h"

namespace caustic {

// Gathers what a walk from the eye finds.
class PathTracer::Visitor {
public:
    Visitor(const PathTracer& tracer, const PathNumbers& numbers, RayCounts& counts)
        : tracer_(tracer), numbers_(numbers), counts_(counts) {}

    bool reached(const Interaction& at, const WalkState& path) {
        if (const Light* const light = at.light()) {
            const Color Le = at.Le();
            if ((Le > 0).any()) meet(path.beta * Le, *light, sampledBefore_ ? light->pdfW(from_, at.hit()) : 0);
        }
        if (!at.scatters() || path.length >= tracer_.settings_.limits.maxLength) return false;
        if (tracer_.settings_.direct != Direct::ByChance && at.connectible()) sampleLight(at, path);
        return true;
    }

    void scattered(const Interaction& at, const BsdfSample& sample) {
        sampledBefore_ = !sample.delta();
        from_ = at.point();
        pdfW_ = sample.pdfW;
    }

    void escaped(const WalkState& path) {
        for (const ChosenLight& one : tracer_.lights_.infinite())
            meet(path.beta * one.light->Le(path.ray), *one.light,
                 sampledBefore_ ? one.light->pdfW(from_, path.ray.direction) : 0);
    }

    const Color& sum() const { return sum_; }

private:
    // A light that the path hits. pdfW is that with which the light is sampled in this direction.
    void meet(const Color& value, const Light& light, Real pdfW) {
        sum_ += value * tracer_.weight(Sampled::Direction, tracer_.lights_.probability(light) * pdfW, pdfW_);
    }

    void sampleLight(const Interaction& at, const WalkState& path) {
        const auto direct = sampleDirectLight(tracer_.scene(), tracer_.lights_, at, path.length - 1, numbers_, counts_);
        if (!direct) return;
        const bool point = direct->light.light->deltaPlace();
        const Real pdfDirection = point ? 0 : at.pdfW(direct->sample.wi);
        sum_ += path.beta * direct->value * tracer_.weight(Sampled::Light, direct->pdfW, pdfDirection);
    }

    const PathTracer& tracer_;
    const PathNumbers& numbers_;
    RayCounts& counts_;
    bool sampledBefore_ = false;  // whether a light was sampled at the vertex before
    Vec3 from_ = Vec3::Zero();
    Real pdfW_ = 1;  // with which the path left it
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

Real PathTracer::weight(Sampled how, Real pdfLight, Real pdfDirection) const {
    //! [ex-07.4]
    const bool light = how == Sampled::Light;
    if (settings_.direct == Direct::ByChance) return light ? 0 : 1;
    if (settings_.direct == Direct::DirectLight) return light || pdfLight == 0 ? 1 : 0;
    // Veach 1997, eq. 9.13 with β = 2.
    return light ? powerHeuristic(pdfLight, pdfDirection) : powerHeuristic(pdfDirection, pdfLight);
    //! [ex-07.4]
}

}  // namespace caustic
