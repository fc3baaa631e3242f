#include "integrator/light_tracer.h"

#include "integrator/camera_connection.h"
#include "integrator/light_start.h"
#include "integrator/walk.h"

namespace caustic {

namespace {

// Splats every vertex that is no specular one.
class SplatVisitor {
public:
    SplatVisitor(const Scene& scene, const PathNumbers& numbers, RayCounts& counts, std::vector<Splat>& splats)
        : scene_(scene), numbers_(numbers), counts_(counts), splats_(splats) {}

    bool reached(const Interaction& at, const WalkState& path) {
        if (!at.connectible()) return true;
        const auto seen = connectToCamera(scene_, at, path.beta, path.length - 1, numbers_, counts_);
        if (seen) splats_.push_back({seen->camera.film, seen->value});
        return true;
    }

    void scattered(const Interaction&, const BsdfSample&) {}
    void escaped(const WalkState&) {}

private:
    const Scene& scene_;
    const PathNumbers& numbers_;
    RayCounts& counts_;
    std::vector<Splat>& splats_;
};

}  // namespace

LightTracer::LightTracer(const Scene& scene, const Sampler& sampler, const PixelFilter& filter,
                         const PathLimits& limits)
    : Integrator(scene, sampler, filter), limits_(checkLimits(limits)), lights_(scene.lights()) {}

Color LightTracer::Li(const Ray& ray, const MediumStack& media, const PathNumbers&, RayCounts& counts) const {
    MediumStack here = media;
    Color transmittance;
    const auto at = scene().follow(ray, here, transmittance, counts);
    return transmittance * (at ? at->Le() : scene().Le(ray));
}

Color LightTracer::tracePath(const PathId& path, std::vector<Splat>& splats, RayCounts& counts) const {
    const PathNumbers numbers = sampler().start(lightStream, path.pixel, path.index);
    if (limits_.maxLength > 1) {
        if (const auto start = startAtLight(scene(), lights_, numbers)) {
            SplatVisitor visitor(scene(), numbers, counts, splats);
            // The connection to the camera is a segment, too.
            const PathLimits limits = {limits_.maxLength - 1, limits_.rouletteStart};
            walk(scene(), {start->emission.ray, start->media, start->beta}, TransportMode::Importance, limits, numbers,
                 counts, visitor);
        }
    }
    return Integrator::tracePath(path, splats, counts);
}

}  // namespace caustic
