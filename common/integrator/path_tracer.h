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

    /// The two ways in which a path meets a light.
    enum class Met { Asked, ByChance };

    /// How much light counts that a path meets in one of the two ways.
    /// @param pdfAsked   density of asking for it, 1/sr; 0 where nobody asks: at the eye, behind a delta lobe
    /// @param pdfChance  density of going there by chance, 1/sr; 0 for a light with a delta place, which no path hits
    Real weight(Met how, Real pdfAsked, Real pdfChance) const;

private:
    class Visitor;

    PathTracerSettings settings_;
    LightChoice lights_;
};

}  // namespace caustic
