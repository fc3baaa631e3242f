#pragma once

#include <cstdint>
#include <vector>

#include "integrator/light_choice.h"
#include "integrator/path_limits.h"
#include "integrator/photon.h"
#include "sampling/sampler.h"
#include "scene/scene.h"

namespace caustic {

/// Photons, by where they have come to. In a medium a photon lies where its light is scattered, with the power that is
/// scattered there, and has no normal (0).
struct VolumePhotons {
    std::vector<Photon> onSurfaces;  ///< that come over other surfaces, or through media: none straight from a lamp
    std::vector<Photon> inMedia;     ///< all of them
};

/// Sends photons out as tracePhotons does, and keeps those that are scattered in a medium, too. Without a medium that
/// scatters it gives the same photons on surfaces, bit for bit.
/// Source: Jensen, Christensen 1998, Efficient Simulation of Light Transport in Scenes with Participating Media using
/// Photon Maps, 4.1.
/// @param first    number of the first photon: the numbers that decide its way belong to it
/// @param count    how many set out; at least 1
/// @param threads  at least 1; the photons and their order don't depend on it
/// @param counts   what was asked of the scene is added
/// @throws InputError when the count or a limit is out of its range
VolumePhotons traceVolumePhotons(const Scene& scene, const LightChoice& lights, const Sampler& sampler,
                                 const PathLimits& limits, std::int64_t first, std::int64_t count, int threads,
                                 RayCounts& counts);

}  // namespace caustic
