#pragma once

#include "integrator/integrator.h"
#include "integrator/light_choice.h"
#include "integrator/path_limits.h"

namespace caustic {

/// How a path from the eye meets lights.
enum class Direct {
    ByChance,     ///< only where it happens to hit one; lights at a point stay dark
    DirectLight,  ///< at each surface that spreads light, one light is asked for; what is hit by chance counts only
                  ///< behind a delta lobe and for the eye itself
    Mis           ///< both, weighted by the power heuristic
};

/// How a PathTracer goes about it.
struct PathTracerSettings {
    PathLimits limits = {};
    Direct direct = Direct::Mis;
};

/// Path tracing: random walks from the eye. The scene's ambient light, which stands for the light that is computed
/// here, is left out. Light that reaches a diffuse surface through smooth glass or over a mirror is found by hitting
/// the lamp by chance only: never when the lamp is a point.
/// Source: Kajiya 1986; direct light and its weights: Veach 9.
class PathTracer final : public Integrator {
public:
    /// @throws InputError when a setting is out of its range
    PathTracer(const Scene& scene, const Sampler& sampler, const PixelFilter& filter,
               const PathTracerSettings& settings);

    Color Li(const Ray& ray, const MediumStack& media, const PathNumbers& numbers, RayCounts& counts) const override;

    /// How the path came to where it is: what decides how much a light counts that it finds there.
    struct Arrival {
        bool counts = true;  ///< whatever it finds counts: it comes from the eye, or from a delta lobe
        Vec3 from = Vec3::Zero();
        Real pdfW = 0;  ///< with which that direction was sampled there, 1/sr
    };

    /// Light from one of the lights that a surface scatters along its wo, an estimate, W/(m²·sr); weighted if both ways
    /// are used.
    /// @param vertex  which vertex of the path it is, from 0
    Color direct(const Interaction& at, int vertex, const PathNumbers& numbers, RayCounts& counts) const;

    /// How much light counts that a path finds by chance.
    /// @param found  its light; pdfW the density with which `direct` picks this direction once it has chosen it, 1/sr
    Real chanceWeight(const Arrival& arrival, const Light& found, Real pdfW) const;

private:
    class Visitor;

    PathTracerSettings settings_;
    LightChoice lights_;
};

}  // namespace caustic
