#pragma once

#include "math/vector.h"

namespace caustic {

/// A point on a surface: what it takes to leave it, to measure it and to look up its texture.
struct SurfacePoint {
    Vec3 point = Vec3::Zero();  ///< as close to the surface as rounding permits, wherever the ray came from

    /// Unit geometric normal. It points to the outside of a closed shape, whatever side the ray came from.
    Vec3 ng = Vec3::UnitZ();

    Vec2 uv = Vec2::Zero();  ///< surface parameters; which ones, each shape says

    /// Largest absolute coordinate that the point was computed from: its own, and those of the shape. Its distance from
    /// the true surface is a small multiple of `magnitude` times the machine epsilon; spawnRay relies on that.
    Real magnitude = 0;
};

}  // namespace caustic
