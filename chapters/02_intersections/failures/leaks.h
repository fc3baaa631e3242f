#pragma once

#include <cstdint>
#include <optional>
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
    bool robust;  ///< whether it is the course's own
    /// Whether the ray hits triangle abc.
    bool (*hits)(const Ray& ray, const Vec3& a, const Vec3& b, const Vec3& c);
    /// Tests every ray against every triangle (three corners each); the number of hits. What a timing calls: what a
    /// method prepares for a ray, it prepares once for all triangles, as in a mesh.
    std::int64_t (*countHits)(const std::vector<Ray>& rays, const std::vector<Vec3>& corners);
};

/// Cramer's rule; the watertight test; the same as its authors print it, without exact signs; and that as a compiler
/// makes it that contracts a·b − c·d to a fused multiply-add.
std::vector<TriangleMethod> triangleMethods();

/// Rays from strictly inside random closed meshes, aimed at points of shared edges or at vertices, that hit no triangle
/// at all. Meshes are new every 10,000 rays; the counts are the same for any number of threads.
/// @param away  how far from the coordinates' origin the meshes are, in their sizes; 0.01 to 100 at random by default
FailureCount countLeaks(const TriangleMethod& method, Aim aim, std::int64_t rays, std::uint64_t seed, int threads,
                        std::optional<Real> away = std::nullopt);

/// Rays that leave a sliver by the course's rule and meet it at once. Slivers are 2 long and `width` wide.
FailureCount countSliverSelfHits(const TriangleMethod& method, Real width, std::int64_t rays, std::uint64_t seed);

}  // namespace caustic
