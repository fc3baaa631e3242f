#pragma once

#include <optional>

#include "scene/scene.h"

namespace caustic {

/// The last vertex of a walk, as a connection needs it; connectible().
struct WalkEnd {
    const Interaction& at;
    const Color& beta;  ///< throughput when the walk gets there; of a walk from a light in W
};

/// Two walks joined by a straight segment.
struct VertexConnection {
    Vec3 wi = Vec3::UnitZ();      ///< unit direction from the eye's vertex to the light's
    Real squaredDistance = 0;     ///< between them, m²; greater than 0
    Color value = Color::Zero();  ///< of the whole path, throughputs of both walks included, unweighted, W/(m²·sr)
};

/// Connects the end of a walk from the eye to the end of one from a light: both scatter towards each other, each
/// what its walk carries (radiance, importance), and what passes between them falls with the square of the distance.
/// The cosines are those that f is multiplied by. The shadow ray leads from the eye's vertex to the light's, in the
/// media on its side.
/// @param counts  what is done in the scene is added
/// @return nothing when the two are at one place, or all three channels of the value are 0: something is in the way,
///         or no light goes there
std::optional<VertexConnection> connectVertices(const Scene& scene, const WalkEnd& eye, const WalkEnd& light,
                                                RayCounts& counts);

}  // namespace caustic
