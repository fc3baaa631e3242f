#pragma once

#include "integrator/integrator.h"
#include "integrator/light_choice.h"
#include "integrator/path_limits.h"

namespace caustic {

/// How a path from the eye meets lights.
enum class Direct {
    ByChance,     ///< only where it happens to hit one; lights at a point stay dark
    DirectLight,  ///< at each vertex that is no specular one, a light is sampled; what is hit by chance counts only
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

    /// What was sampled to get from a vertex to a light: a point of the light, or the direction in which the path goes
    /// on (BSDF sampling), which hits the light by chance.
    enum class Sampled { Light, Direction };

    /// How much light counts that was found by one of the two, in [0, 1], as PathTracerSettings::direct says; the
    /// two weights of one way to the light sum to 1, wherever both can find it.
    /// @param pdfLight      density of light sampling, 1/sr, the choice of the light included; 0 where no light is
    ///                      sampled: at the eye, behind a delta lobe
    /// @param pdfDirection  density of the path's going there by chance, 1/sr; 0 for a light with a delta place, which
    ///                      no path hits
    Real weight(Sampled how, Real pdfLight, Real pdfDirection) const;

private:
    class Visitor;

    PathTracerSettings settings_;
    LightChoice lights_;
};

}  // namespace caustic
