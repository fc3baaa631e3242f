#pragma once

#include <optional>
#include <string>

#include "integrator/integrator.h"
#include "integrator/light_choice.h"
#include "integrator/path_limits.h"
#include "integrator/photon_grid.h"
#include "integrator/photon_volume.h"

namespace caustic {

/// How VolumeSppm finds light that comes straight from the lamps and is scattered once, on its way to the eye.
enum class MediumDirect {
    Photons,      ///< by photons, as all other light in media: the report's way
    EquiAngular,  ///< sampled at places picked around the lamp
    Marching      ///< in equal steps: biased
};

/// Settings of VolumeSppm.
struct VolumeSppmSettings {
    PathLimits limits = {};  ///< segments from the eye and from the light to where they meet, together
    Real alpha = 2.0 / 3;    ///< of both radii, in (0, 1): see radiusOfPass
    Real radius = 0;         ///< of the first pass on surfaces, m; 0 for usualRadius of the scene
    Real beamRadius = 0;     ///< of the first pass around rays, m; 0 for the same
    int photons = 1 << 16;   ///< that set out in each pass; 0 for direct light alone
    MediumDirect direct = MediumDirect::EquiAngular;
    int places = 1;  ///< along each piece of a ray within a medium, where direct light is looked for; at least 1
};

/// Stochastic progressive photon mapping that sees what is in the air: photons lie in media, too, and each ray of the
/// eye gathers those along all of its way. What shines through a glass and makes a caustic on the table is a shaft of
/// light in the fog above it. Passes depend on nothing but their number. In a scene without a medium that scatters it
/// does what Sppm does by RadiusRule::Pass.
/// Source: Jarosz, Zwicker, Jensen 2008; Knaus, Zwicker 2011, whose rule for discs holds for beams.
class VolumeSppm final : public Integrator {
public:
    /// @throws InputError when a setting is out of its range
    VolumeSppm(const Scene& scene, const Sampler& sampler, const PixelFilter& filter,
               const VolumeSppmSettings& settings);

    Rendering runPass(const Pass& pass, int threads) override;

    /// With the photons of the pass that was run last.
    Color Li(const Ray& ray, const MediumStack& media, const PathNumbers& numbers, RayCounts& counts) const override;

    /// Why it traces no photons; empty when it does.
    std::string whyNoPhotons() const;

private:
    void traceNewPhotons(std::int64_t pass, int threads, RayCounts& counts);
    Color scatteredAlong(const MediumSpan& span, int length, std::uint64_t which, const PathNumbers& numbers,
                         RayCounts& counts) const;
    Color atSurface(const VisiblePoint& point, const PathNumbers& numbers, RayCounts& counts) const;

    VolumeSppmSettings settings_;
    LightChoice lights_;
    Real radius_;      // of the last pass
    Real beamRadius_;  // the same
    std::optional<PhotonGrid> onSurfaces_;
    std::optional<PhotonVolume> inMedia_;
};

}  // namespace caustic
