#pragma once

#include <optional>

#include "mesh/mesh_tree.h"
#include "shape/watertight.h"

namespace caustic {

/// The nearest triangle that a ray has met so far. Its t is where the ray ends from then on.
class NearestTriangle {
public:
    NearestTriangle(const MeshData& mesh, const Ray& ray) : mesh_(mesh), sheared_(ray) {}

    /// Tests a triangle.
    /// @return whether the ray meets it, before all others
    bool test(std::uint32_t triangle) {
        const auto& [i, j, k] = mesh_.triangles[triangle];
        const auto found = intersectWatertight(sheared_, mesh_.positions[i], mesh_.positions[j], mesh_.positions[k]);
        if (!found) return false;
        keep(*found, triangle);
        return true;
    }

    /// Takes what a test of many triangles found.
    /// @return whether it is before all others
    bool offer(const TriangleHit& hit, std::uint32_t triangle) {
        if (!sheared_.ray.reaches(hit.t)) return false;
        keep(hit, triangle);
        return true;
    }

    /// The ray, which ends at the nearest hit.
    const ShearedRay& sheared() const { return sheared_; }
    Real tMax() const { return sheared_.ray.tMax; }
    /// Nothing as long as nothing was hit.
    const std::optional<MeshHit>& nearest() const { return nearest_; }

private:
    void keep(const TriangleHit& hit, std::uint32_t triangle) {
        sheared_.ray.tMax = hit.t;
        nearest_ = MeshHit{hit, triangle};
    }

    const MeshData& mesh_;
    ShearedRay sheared_;
    std::optional<MeshHit> nearest_;
};

}  // namespace caustic
