#include "mesh/triangle_clip.h"

#include <array>

#include "core/not_implemented.h"

namespace caustic {

namespace {

// A triangle has at most nine corners left after six planes.
struct Polygon {
    std::array<Vec3, 9> corners;
    std::size_t count = 0;

    void add(const Vec3& corner) { corners[count++] = corner; }
};

// Keeps what is on one side of the plane x[axis] = at: above it for sign 1, below it for sign -1.
Polygon clipped(const Polygon& polygon, int axis, Real at, Real sign) {
    Polygon kept;
    for (std::size_t i = 0; i < polygon.count; ++i) {
        const Vec3& from = polygon.corners[i];
        const Vec3& to = polygon.corners[(i + 1) % polygon.count];
        const Real before = sign * (from[axis] - at);
        const Real after = sign * (to[axis] - at);
        if (before >= 0) kept.add(from);
        if ((before < 0) == (after < 0) || before == 0 || after == 0) continue;
        Vec3 crossing = from + before / (before - after) * (to - from);
        crossing[axis] = at;
        kept.add(crossing);
    }
    return kept;
}

}  // namespace

Bounds3 clippedTriangleBounds(const Vec3& a, const Vec3& b, const Vec3& c, const Bounds3& inside) {
    //! [ex-04.4]
    Polygon polygon;
    for (const Vec3& corner : {a, b, c}) polygon.add(corner);
    for (int axis = 0; axis < 3; ++axis) {
        polygon = clipped(polygon, axis, inside.min()[axis], 1);
        polygon = clipped(polygon, axis, inside.max()[axis], -1);
    }
    Bounds3 box;
    for (std::size_t i = 0; i < polygon.count; ++i) box.extend(polygon.corners[i]);
    // A crossing may be rounded out of a plane that was dealt with before.
    return box.isEmpty() ? box : box.intersection(inside);
    //! [ex-04.4]
}

}  // namespace caustic
