#pragma once

#include "integrator/integrator.h"
#include "integrator/light_choice.h"
#include "integrator/path_limits.h"

namespace caustic {

/// What one strategy adds.
struct StrategyContribution {
    int s = 0;                    ///< vertices from the light
    int t = 0;                    ///< vertices from the eye, the pinhole among them
    Color value = Color::Zero();  ///< unweighted: what the strategy would estimate by itself, W/(m²·sr)
    Real weight = 0;              ///< by the power heuristic, in [0, 1]

    /// Where on the film, in pixels, for t = 1; otherwise it belongs to the path's own pixel.
    Vec2 film = Vec2::Zero();
};

/// Bidirectional path tracing: one walk from the eye and one from a light, and every way to make paths of the two. The
/// strategy (s, t) takes s vertices from the light's walk and t from the eye's: s = 0, the eye's walk hits a light by
/// chance; s = 1, a light is sampled at the eye's vertex, a new point of it each time; t = 1, the light's vertex is
/// connected to the camera and splatted; else the two ends are connected. What several strategies can make is weighted
/// by the power heuristic over all of them. Lights that are seen directly come by s = 0 alone.
///
/// What it cannot make: light from a point that goes by delta lobes only between two non-specular surfaces, seen by
/// delta lobes only, or comes to the eye by delta lobes alone. What it makes by chance only: specular, diffuse,
/// specular. Source: Veach 1997, ch. 10; Lafortune, Willems 1993, Bi-directional Path Tracing.
class BidirectionalPathTracer final : public Integrator {
public:
    /// @throws InputError when a limit is out of its range
    BidirectionalPathTracer(const Scene& scene, const Sampler& sampler, const PixelFilter& filter,
                            const PathLimits& limits);

    /// Without a film there is nothing to splat to: by the strategies with t of at least 2, weighted among themselves.
    Color Li(const Ray& ray, const MediumStack& media, const PathNumbers& numbers, RayCounts& counts) const override;
    Color tracePath(const PathId& path, std::vector<Splat>& splats, RayCounts& counts) const override;

    /// Everything that a path contributes, strategy by strategy; tracePath is the sum of weight · value.
    std::vector<StrategyContribution> contributions(const PathId& path, RayCounts& counts) const;

private:
    struct LightVertex;
    struct Subpaths;
    class LightVisitor;
    class EyeVisitor;

    void walkFromLight(const PathNumbers& numbers, bool splat, RayCounts& counts, Subpaths& found) const;

    PathLimits limits_;
    LightChoice lights_;
};

}  // namespace caustic
