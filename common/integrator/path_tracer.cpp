#include "integrator/path_tracer.h"

#include "core/not_implemented.h"
#include "integrator/direct_light.h"
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
            if ((Le > 0).any()) meet(path.beta * Le, *light, asksBefore_ ? light->pdfW(from_, at.hit()) : 0);
        }
        if (at.bsdf() == nullptr || path.length >= tracer_.settings_.limits.maxLength) return false;
        if (tracer_.settings_.direct != Direct::ByChance && anyOf(at.bsdf()->lobes(), spread)) ask(at, path);
        return true;
    }

    void scattered(const Interaction& at, const BsdfSample& sample) {
        asksBefore_ = !sample.delta();
        from_ = at.hit().point;
        pdfW_ = sample.pdfW;
    }

    void escaped(const WalkState& path) {
        for (const ChosenLight& one : tracer_.lights_.infinite())
            meet(path.beta * one.light->Le(path.ray), *one.light,
                 asksBefore_ ? one.light->pdfW(from_, path.ray.direction) : 0);
    }

    const Color& sum() const { return sum_; }

private:
    // A light by chance. pdfW is that with which it picks this direction when it is asked.
    void meet(const Color& value, const Light& light, Real pdfW) {
        sum_ += value * tracer_.weight(Met::ByChance, tracer_.lights_.probability(light) * pdfW, pdfW_);
    }

    void ask(const Interaction& at, const WalkState& path) {
        const auto direct = askForLight(tracer_.scene(), tracer_.lights_, at, path.length - 1, numbers_, counts_);
        if (!direct) return;
        const bool point = direct->light.light->deltaPlace();
        const Real byChance = point ? 0 : at.bsdf()->pdfW(at.wo(), direct->sample.wi);
        sum_ += path.beta * direct->value * tracer_.weight(Met::Asked, direct->pdfW, byChance);
    }

    const PathTracer& tracer_;
    const PathNumbers& numbers_;
    RayCounts& counts_;
    bool asksBefore_ = false;  // whether a light was asked for at the vertex before
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

Real PathTracer::weight(Met how, Real pdfAsked, Real pdfChance) const {
    //! [ex-07.4]
    const bool asked = how == Met::Asked;
    if (settings_.direct == Direct::ByChance) return asked ? 0 : 1;
    if (settings_.direct == Direct::DirectLight) return asked || pdfAsked == 0 ? 1 : 0;
    return asked ? powerHeuristic(pdfAsked, pdfChance) : powerHeuristic(pdfChance, pdfAsked);
    //! [ex-07.4]
}

}  // namespace caustic
