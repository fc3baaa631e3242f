#include "math/spawn.h"

#include <algorithm>

#include "core/not_implemented.h"

namespace caustic {

Vec3 offsetPoint(const SurfacePoint& from, const Vec3& direction, Real magnitude) {
    //! [ex-02.8]
    const Real distance = surfaceOffset * magnitude;
    const Real side = direction.dot(from.ng) >= 0 ? 1 : -1;
    return from.point + side * distance * from.ng;
    //! [ex-02.8]
}

Ray spawnRay(const SurfacePoint& from, const Vec3& direction) {
    return {offsetPoint(from, direction, from.magnitude), direction};
}

Ray spawnRayTo(const SurfacePoint& from, const Vec3& to) {
    const Vec3 origin = offsetPoint(from, to - from.point, from.magnitude);
    return {origin, to - origin, 0, 1};
}

Ray spawnRayTo(const SurfacePoint& from, const SurfacePoint& to) {
    // A small thing beside a large one: the ray's rounding errors are relative to the larger magnitude at both ends.
    const Real magnitude = std::max(from.magnitude, to.magnitude);
    const Vec3 way = to.point - from.point;
    const Vec3 origin = offsetPoint(from, way, magnitude);
    return {origin, offsetPoint(to, -way, magnitude) - origin, 0, 1};
}

}  // namespace caustic
