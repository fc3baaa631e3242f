#pragma once

#include "image/ray_view.h"
#include "math/bounds.h"
#include "math/hit.h"

namespace caustic {

/// A view of a box from the direction `from`, with some room around it.
RayView viewOf(const Bounds3& box, const Vec3& from);

/// Plaster under two lights and a pale sky, shaded by the shading normal.
Color plaster(const Hit& hit, const Vec3& wo);

}  // namespace caustic
