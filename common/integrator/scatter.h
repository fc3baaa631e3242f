#pragma once

#include <optional>

#include "sampling/sampler.h"
#include "scene/interaction.h"

namespace caustic {

/// How a path goes on from a vertex.
struct Scattering {
    BsdfSample sample;             ///< where to
    Color weight = Color::Zero();  ///< what the throughput is multiplied by: f |cos| / p, of a delta lobe f / p
};

/// Samples how a path goes on from a vertex.
/// @param at      one that scatters()
/// @param mode    what the path carries
/// @param vertex  which vertex of the path it is, from 0: whose numbers are taken, the pair Direction and Lobe
/// @return nothing when the path ends here
std::optional<Scattering> scatter(const Interaction& at, TransportMode mode, const PathNumbers& numbers, int vertex);

}  // namespace caustic
