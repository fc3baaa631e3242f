#pragma once

#include <cmath>

#include "light/light.h"
#include "math/spawn.h"

namespace caustic {

/// What arrives at a point from a light at another point: intensity over distance squared; nothing when they coincide.
inline std::optional<DirectSample> directFromPoint(const SurfacePoint& from, const Vec3& light,
                                                   const Color& intensity) {
    const Vec3 way = light - from.point;
    const Real squared = way.squaredNorm();
    if (!(squared > 0) || (intensity == 0).all()) return std::nullopt;
    // PBR, 4th ed., 12.2: intensity over distance squared.
    return DirectSample{way / std::sqrt(squared),
                        intensity / squared,
                        1,
                        spawnRayTo(from, light),
                        {.point = light, .ng = Vec3::Zero()}};
}

}  // namespace caustic
