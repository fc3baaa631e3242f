#pragma once

#include <optional>

#include "integrator/path_limits.h"
#include "integrator/walk.h"

namespace caustic {

/// Where a path from the eye first meets something that scatters light into more than single directions, straight or
/// over mirrors and through glass.
struct VisiblePoint {
    Interaction at;              ///< connectible()
    Color beta = Color::Zero();  ///< throughput of the path from the eye
    int length = 0;              ///< segments from the eye to it
};

/// What a path from the eye finds on the way to its visible point.
struct EyePath {
    Color seen = Color::Zero();         ///< of lamps that it meets, straight or over delta lobes, W/(m²·sr)
    std::optional<VisiblePoint> point;  ///< nothing when it leaves the scene, is absorbed or gets too long
};

/// Follows a path from the eye to its visible point.
/// @param ray      unit direction
/// @param media    what it starts in
/// @param numbers  the path's
/// @param counts   what was asked of the scene is added
EyePath findVisiblePoint(const Scene& scene, const Ray& ray, const MediumStack& media, const PathLimits& limits,
                         const PathNumbers& numbers, RayCounts& counts);

}  // namespace caustic
