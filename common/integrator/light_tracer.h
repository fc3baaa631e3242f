#pragma once

#include "integrator/integrator.h"
#include "integrator/light_choice.h"
#include "integrator/path_limits.h"

namespace caustic {

/// Light tracing: random walks from the lights; each vertex is connected to the camera and splatted where it is seen.
/// With each path of a pixel one path sets out from a light. Lights that are seen directly come from the eye's side:
/// one ray a path, which is all that Li estimates.
///
/// What it cannot make: whatever is seen over a mirror or through smooth glass, L(S|D)*SE, since the last surface
/// before the pinhole has to be a non-specular one; lights seen that way among it. That light is missing. Source: Arvo
/// 1986, Backward Ray Tracing; Dutré, Lafortune, Willems 1993, Monte Carlo Light Tracing.
class LightTracer final : public Integrator {
public:
    /// @throws InputError when a limit is out of its range
    LightTracer(const Scene& scene, const Sampler& sampler, const PixelFilter& filter, const PathLimits& limits);

    /// Light that comes straight from a light.
    Color Li(const Ray& ray, const MediumStack& media, const PathNumbers& numbers, RayCounts& counts) const override;
    Color tracePath(const PathId& path, std::vector<Splat>& splats, RayCounts& counts) const override;

private:
    PathLimits limits_;
    LightChoice lights_;
};

}  // namespace caustic
