#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "leaving.h"
#include "math/ray.h"

namespace caustic {

/// Where on a closed mesh a ray is aimed at.
enum class Aim { Edges, Vertices };

/// A way to test triangles, as charts and tables name it.
struct TriangleMethod {
    std::string name;
    /// Whether the ray hits triangle abc.
    bool (*hits)(const Ray& ray, const Vec3& a, const Vec3& b, const Vec3& c);
    /// Tests so many triangles, one ray for each; the number of hits. What a timing calls.
    std::int64_t (*countHits)(const std::vector<Ray>& rays, const std::vector<Vec3>& corners);
};

/// Cramer's rule; the watertight test; the watertight test as a compiler makes it that contracts a·b − c·d to a fused
/// multiply-add.
std::vector<TriangleMethod> triangleMethods();

/// Rays from strictly inside random closed meshes, aimed at points of shared edges or at vertices, that hit no triangle
/// at all. Meshes are new every 10,000 rays; the counts are the same for any number of threads.
FailureCount countLeaks(const TriangleMethod& method, Aim aim, std::int64_t rays, std::uint64_t seed, int threads);

}  // namespace caustic
