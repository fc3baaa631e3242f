#include "integrator/bidirectional_path_tracer.h"

#include "integrator/camera_connection.h"
#include "integrator/density_walk.h"
#include "integrator/direct_light.h"
#include "integrator/light_start.h"
#include "integrator/vertex_connection.h"
#include "integrator/walk.h"

namespace caustic {

namespace {

constexpr std::size_t mostUsual = 8;  // vertices of a walk, for which room is made at once

// Whether a walk can find the light by chance.
bool canBeHit(const Light& light) { return !light.deltaPlace(); }

// The walk that starts with this sample, at its first vertex, the light. Georgiev 2012, eq. 31 to 33, and 48 to 50
// for a light that is never hit.
DensityWalk startOf(const LightStart& start) {
    const EmissionSample& emission = start.emission;
    const Light& light = *start.light.light;
    const Real cosine = std::max(std::abs(emission.ng.dot(emission.ray.direction)), Real(1e-60));
    // At infinity the first vertex is a direction, and the place picks the second one.
    if (light.infinite())
        return {PathDensity::start(start.light.probability * emission.pdfW, canBeHit(light)),
                {.forward = emission.pdfA},
                std::nullopt,
                1};
    return {PathDensity::start(start.light.probability * emission.pdfA, canBeHit(light)),
            {.forward = emission.pdfW},
            emission.ray.origin,
            cosine};
}

// The walk that starts at the eye, which no walk from a light hits by chance.
// @param pdfW  density of the ray's direction on the film, 1/sr; 0 where nothing is splatted: beyond the film's edges,
//              or without a film
DensityWalk startOf(const Ray& ray, Real pdfW) {
    const bool splatted = pdfW > 0;
    return {PathDensity::start(1, false), {.forward = splatted ? pdfW : 1, .connectible = splatted}, ray.origin, 1};
}

}  // namespace

struct BidirectionalPathTracer::LightVertex {
    Interaction at;
    Color beta;
    PathDensity density;
    int s = 0;  // vertices from the light, this one included
};

// The walk from the light, and what has been made of both walks so far.
struct BidirectionalPathTracer::Subpaths {
    std::vector<LightVertex> light;
    std::vector<StrategyContribution> contributions;
};

// Keeps the vertices of a walk from a light, and splats them.
class BidirectionalPathTracer::LightVisitor {
public:
    LightVisitor(const Scene& scene, const LightStart& start, const PathNumbers& numbers, bool splat, RayCounts& counts,
                 Subpaths& found)
        : scene_(scene), numbers_(numbers), counts_(counts), found_(found), walk_(startOf(start)), splat_(splat) {}

    bool reached(const Interaction& at, const WalkState& path) {
        if (!at.scatters()) return false;
        walk_.reach(at);
        if (!at.connectible()) return true;
        if (splat_) splat(at, path);
        found_.light.push_back({at, path.beta, walk_.density(), path.length + 1});
        return true;
    }

    void scattered(const Interaction& at, const BsdfSample& sample) { walk_.scatter(at, sample); }
    void escaped(const WalkState&) {}

private:
    // (s, 1)
    void splat(const Interaction& at, const WalkState& path) {
        const auto seen = connectToCamera(scene_, at, path.beta, path.length - 1, numbers_, counts_);
        if (!seen) return;
        const ImportanceSample& camera = seen->camera;
        const Real pdfW = scene_.camera().pdf({camera.lens, -camera.wi}).pdfW;
        // Veach 1997, 8.2.2: over area.
        const Real reverse = pdfW * at.geometricCosine(camera.wi) / (camera.distance * camera.distance);
        // Georgiev 2012, eq. 46; eq. 47, the eye's share, is 0.
        const Real others = walk_.density().others(reverse, at.reversePdfW(camera.wi));
        found_.contributions.push_back({path.length + 1, 1, seen->value, strategyWeight(others, 0), camera.film});
    }

    const Scene& scene_;
    const PathNumbers& numbers_;
    RayCounts& counts_;
    Subpaths& found_;
    DensityWalk walk_;
    bool splat_;
};

// Meets lights, samples them, and connects to the vertices of the walk from the light.
class BidirectionalPathTracer::EyeVisitor {
public:
    EyeVisitor(const BidirectionalPathTracer& tracer, const DensityWalk& start, const PathNumbers& numbers,
               RayCounts& counts, Subpaths& found)
        : tracer_(tracer), numbers_(numbers), counts_(counts), found_(found), walk_(start) {}

    bool reached(const Interaction& at, const WalkState& path) {
        walk_.reach(at);
        if (at.light() != nullptr) hit(at, path);
        if (!at.scatters() || path.length >= tracer_.limits_.maxLength) return false;
        if (!at.connectible()) return true;
        sampleLight(at, path);
        for (const LightVertex& light : found_.light) {
            if (light.s + path.length <= tracer_.limits_.maxLength) connect(at, path, light);
        }
        return true;
    }

    void scattered(const Interaction& at, const BsdfSample& sample) { walk_.scatter(at, sample); }

    void escaped(const WalkState& path) {
        walk_.escape();
        for (const ChosenLight& one : tracer_.lights_.infinite()) {
            const EmissionPdf pdf = one.light->pdfEmission({}, -path.ray.direction);
            // Georgiev 2012, eq. 43.
            const Real others = walk_.density().others(one.probability * pdf.pdfW, pdf.pdfA);
            add(0, path.length + 1, path.beta * one.light->Le(path.ray), seenDirectly(path) ? 0 : others);
        }
    }

private:
    // (0, t)
    void hit(const Interaction& at, const WalkState& path) {
        const Color Le = at.Le();
        if ((Le == 0).all()) return;
        const EmissionPdf pdf = at.light()->pdfEmission(at.hit(), at.wo());
        // Georgiev 2012, eq. 43; eq. 42, the light's share, is 0.
        const Real others = walk_.density().others(tracer_.lights_.probability(*at.light()) * pdf.pdfA, pdf.pdfW);
        add(0, path.length + 1, path.beta * Le, seenDirectly(path) ? 0 : others);
    }

    // (1, t)
    void sampleLight(const Interaction& at, const WalkState& path) {
        const auto direct = sampleDirectLight(tracer_.scene(), tracer_.lights_, at, path.length - 1, numbers_, counts_);
        if (!direct) return;
        const Light& light = *direct->light.light;
        const DirectSample& sample = direct->sample;

        // Georgiev 2012, eq. 44: the light's only vertex, in the measure of solid angle, seen from here.
        const Real fromLight = PathDensity::start(direct->pdfW, canBeHit(light)).others(at.pdfW(sample.wi), 0);
        const EmissionPdf pdf = light.pdfEmission(sample.on, -sample.wi);
        // Veach 1997, 8.2.2: over area. What comes from infinity has a density over the disc that it passes.
        const Real perArea = light.infinite() ? pdf.pdfA : pdf.pdfW / sample.ray.direction.squaredNorm();
        // Georgiev 2012, eq. 45.
        const Real fromEye = walk_.density().others(perArea * at.geometricCosine(sample.wi), at.reversePdfW(sample.wi));
        add(1, path.length + 1, path.beta * direct->value, fromLight + fromEye);
    }

    // (s, t)
    void connect(const Interaction& z, const WalkState& path, const LightVertex& light) {
        const Interaction& y = light.at;
        const auto joined = connectVertices(tracer_.scene(), {z, path.beta}, {y, light.beta}, counts_);
        if (!joined) return;
        const Vec3& wi = joined->wi;
        // Veach 1997, 8.2.2: each end is picked by the other one, over area.
        const Real pickedY = z.pdfW(wi) * y.geometricCosine(wi) / joined->squaredDistance;
        const Real pickedZ = y.pdfW(-wi) * z.geometricCosine(wi) / joined->squaredDistance;
        // Georgiev 2012, eq. 40.
        const Real fromLight = light.density.others(pickedY, y.reversePdfW(-wi));
        // Georgiev 2012, eq. 41.
        const Real fromEye = walk_.density().others(pickedZ, z.reversePdfW(wi));
        add(light.s, path.length + 1, joined->value, fromLight + fromEye);
    }

    static bool seenDirectly(const WalkState& path) { return path.length == 1; }

    void add(int s, int t, const Color& value, Real others) {
        found_.contributions.push_back({s, t, value, strategyWeight(others, 0), Vec2::Zero()});
    }

    const BidirectionalPathTracer& tracer_;
    const PathNumbers& numbers_;
    RayCounts& counts_;
    Subpaths& found_;
    DensityWalk walk_;
};

BidirectionalPathTracer::BidirectionalPathTracer(const Scene& scene, const Sampler& sampler, const PixelFilter& filter,
                                                 const PathLimits& limits)
    : Integrator(scene, sampler, filter), limits_(checkLimits(limits)), lights_(scene.lights()) {}

void BidirectionalPathTracer::walkFromLight(const PathNumbers& numbers, bool splat, RayCounts& counts,
                                            Subpaths& found) const {
    if (limits_.maxLength < 2) return;
    const auto start = startAtLight(scene(), lights_, numbers);
    if (!start) return;
    found.light.reserve(mostUsual);
    LightVisitor visitor(scene(), *start, numbers, splat, counts, found);
    // What connects it to the eye is a segment, too.
    const PathLimits limits = {limits_.maxLength - 1, limits_.rouletteStart};
    walk(scene(), {start->emission.ray, start->media, start->beta}, TransportMode::Importance, limits, numbers, counts,
         visitor);
}

Color BidirectionalPathTracer::Li(const Ray& ray, const MediumStack& media, const PathNumbers& numbers,
                                  RayCounts& counts) const {
    Subpaths found;
    walkFromLight(numbers.branch(lightStream), false, counts, found);
    EyeVisitor visitor(*this, startOf(ray, 0), numbers, counts, found);
    walk(scene(), {ray, media, Color::Ones()}, TransportMode::Radiance, limits_, numbers, counts, visitor);
    Color sum = Color::Zero();
    for (const StrategyContribution& one : found.contributions) sum += one.weight * one.value;
    return sum;
}

std::vector<StrategyContribution> BidirectionalPathTracer::contributions(const PathId& path, RayCounts& counts) const {
    Subpaths found;
    walkFromLight(sampler().start(lightStream, path.pixel, path.index), true, counts, found);
    const PathNumbers numbers = sampler().start(eyeStream, path.pixel, path.index);
    const Ray ray = eyeRay(path, numbers, counts);
    EyeVisitor visitor(*this, startOf(ray, scene().camera().pdf(ray).pdfW), numbers, counts, found);
    walk(scene(), {ray, scene().cameraMedia(), Color::Ones()}, TransportMode::Radiance, limits_, numbers, counts,
         visitor);
    return found.contributions;
}

Color BidirectionalPathTracer::tracePath(const PathId& path, std::vector<Splat>& splats, RayCounts& counts) const {
    Color sum = Color::Zero();
    for (const StrategyContribution& one : contributions(path, counts)) {
        if (one.t == 1) {
            splats.push_back({one.film, one.weight * one.value});
        } else {
            sum += one.weight * one.value;
        }
    }
    return sum;
}

}  // namespace caustic
