#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/random.h"
#include "math/vector.h"

namespace caustic::test {

/// Points of one kind, and queries around them.
struct PointCloud {
    std::string name;
    std::vector<Vec3> points;
    Real size = 1;  ///< about how large it is

    /// A query: at a point, near one, in between, or outside.
    Vec3 query(Random& random) const {
        const auto inCube = [&random] {
            return Vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
        };
        const Vec3 near = points.empty() ? Vec3::Zero() : points[random.below(points.size())];
        switch (random.below(4)) {
            case 0:
                return near;
            case 1:
                return near + 1e-3 * size * inCube();
            case 2:
                return near + 0.3 * size * inCube();
            default:
                return near + 5 * size * inCube();
        }
    }
};

/// A cloud of each kind with n points: in a cube, on a box's faces, in clusters, on a line, few places many times,
/// tiny and far from the origin, huge.
inline std::vector<PointCloud> pointClouds(std::size_t n, std::uint64_t seed) {
    const auto inCube = [](Random& random) {
        return Vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    };
    const std::vector<std::pair<std::string, std::function<Vec3(Random&)>>> kinds = {
        {"cube", inCube},
        {"faces",
         [&](Random& random) {
             Vec3 point = inCube(random);
             point[static_cast<int>(random.below(3))] = random.below(2) == 0 ? -1 : 1;
             return point;
         }},
        {"clusters",
         [&](Random& random) -> Vec3 {
             const Real spread = std::pow(10, random.uniform(-8, 0));
             return spread * inCube(random) + Vec3(static_cast<Real>(random.below(3)), 0, 0);
         }},
        {"line", [](Random& random) -> Vec3 { return random.uniform(-1, 1) * Vec3(1, 2, -3); }},
        {"few places",
         [](Random& random) {
             return Vec3(static_cast<Real>(random.below(2)), static_cast<Real>(random.below(2)),
                         static_cast<Real>(random.below(2)));
         }},
        {"tiny and far", [&](Random& random) -> Vec3 { return Vec3(1e3, -2e3, 5e2) + 1e-6 * inCube(random); }},
        {"huge", [&](Random& random) -> Vec3 { return 1e6 * inCube(random) + Vec3(3e7, 0, 0); }}};
    std::vector<PointCloud> clouds;
    for (const auto& [name, make] : kinds) {
        PointCloud cloud = {name, {}, name == "tiny and far" ? 1e-6 : name == "huge" ? 1e6 : 1};
        Random random(seed, {clouds.size(), n});
        for (std::size_t i = 0; i < n; ++i) cloud.points.push_back(make(random));
        clouds.push_back(std::move(cloud));
    }
    return clouds;
}

}  // namespace caustic::test
