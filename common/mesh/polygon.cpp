#include "mesh/polygon.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/not_implemented.h"

namespace caustic {

namespace {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

// Sum over the edges: along the polygon's normal, twice its area long.
Vec3 newellNormal(std::span<const Vec3> corners) {
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec3 from = corners[i] - corners[0];
        sum += from.cross(corners[(i + 1) % corners.size()] - corners[0]);
    }
    return sum;
}

// The corners, seen against the normal, so that they run counterclockwise.
std::vector<Vec2> projected(std::span<const Vec3> corners) {
    const Vec3 normal = newellNormal(corners);
    int axis = 0;
    normal.cwiseAbs().maxCoeff(&axis);
    const int x = (axis + 1) % 3;
    const int y = (axis + 2) % 3;
    const Real mirror = normal[axis] < 0 ? -1 : 1;
    std::vector<Vec2> points;
    points.reserve(corners.size());
    for (const Vec3& corner : corners) points.emplace_back(mirror * corner[x], corner[y]);
    return points;
}

// Positive where a, b, c turn left.
Real turn(const Vec2& a, const Vec2& b, const Vec2& c) { return (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x(); }

bool turnsLeftOnly(std::span<const Vec2> points) {
    const std::size_t count = points.size();
    for (std::size_t i = 0; i < count; ++i) {
        if (turn(points[i], points[(i + 1) % count], points[(i + 2) % count]) < 0) return false;
    }
    return true;
}

// Whether the triangle at place i of the ring can be cut off: it turns left, and no other corner is in it.
bool isEar(std::span<const Vec2> points, const std::vector<std::uint32_t>& ring, std::size_t i) {
    const std::size_t count = ring.size();
    const Vec2& a = points[ring[(i + count - 1) % count]];
    const Vec2& b = points[ring[i]];
    const Vec2& c = points[ring[(i + 1) % count]];
    if (!(turn(a, b, c) > 0)) return false;
    return std::ranges::none_of(ring, [&](std::uint32_t other) {
        const Vec2& p = points[other];
        if (p == a || p == b || p == c) return false;
        return turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0;
    });
}

}  // namespace

bool isConvex(std::span<const Vec3> corners) { return turnsLeftOnly(projected(corners)); }

Triangles triangulated(std::span<const Vec3> corners) {
    //! [ex-04.7]
    Triangles triangles;
    const auto count = static_cast<std::uint32_t>(corners.size());
    const std::vector<Vec2> points = projected(corners);
    if (count == 3 || turnsLeftOnly(points)) {
        for (std::uint32_t i = 2; i < count; ++i) triangles.push_back({0, i - 1, i});
        return triangles;
    }
    std::vector<std::uint32_t> ring;
    for (std::uint32_t i = 0; i < count; ++i) ring.push_back(i);
    std::size_t place = 0;
    while (ring.size() > 3) {
        std::size_t ear = place;
        for (std::size_t tried = 0; tried < ring.size(); ++tried) {
            if (isEar(points, ring, (place + tried) % ring.size())) {
                ear = (place + tried) % ring.size();
                break;
            }
        }
        // Without an ear the polygon crosses itself or has no area: any corner will do.
        const std::size_t size = ring.size();
        triangles.push_back({ring[(ear + size - 1) % size], ring[ear], ring[(ear + 1) % size]});
        ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(ear));
        place = ear % ring.size();
    }
    triangles.push_back({ring[0], ring[1], ring[2]});
    return triangles;
    //! [ex-04.7]
}

}  // namespace caustic
