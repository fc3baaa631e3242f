#pragma once

#include <cstdint>
#include <vector>

#include "integrator/light_choice.h"
#include "integrator/path_limits.h"
#include "integrator/photon.h"
#include "sampling/sampler.h"
#include "scene/scene.h"

namespace caustic {

/// What happens to photons on their way.
struct PhotonSettings {
    /// How far they go.
    PathLimits limits = {};

    /// At so many of its first vertices a photon is split: it goes on by all lobes of the surface at once, each part
    /// with its share of the power. At all others roulette picks one lobe. At least 0, at most 16, since each split
    /// doubles the photons behind smooth glass.
    int splits = 0;

    /// Whether photons that come straight from a lamp are kept. An integrator that samples direct light at each
    /// point needs none.
    bool direct = true;
};

/// Sends photons out from the lamps and keeps a copy of each wherever it comes to a non-specular surface. A lamp gets
/// photons in proportion to its power. The powers of all photons that set out sum to that of the lamps, in the mean; a
/// photon that is reflected lies at each of the surfaces with what it brings there. Source: Jensen 1996, Global
/// Illumination using Photon Maps, 2.1; Jensen 2001, Realistic Image Synthesis using Photon Mapping, ch. 5.
/// @param first    number of the first photon: the numbers that decide its way belong to it
/// @param count    how many set out; at least 1
/// @param threads  at least 1; the photons and their order don't depend on it
/// @param counts   what was asked of the scene is added
/// @throws InputError when a setting or the count is out of its range
std::vector<Photon> tracePhotons(const Scene& scene, const LightChoice& lights, const Sampler& sampler,
                                 const PhotonSettings& settings, std::int64_t first, std::int64_t count, int threads,
                                 RayCounts& counts);

}  // namespace caustic
