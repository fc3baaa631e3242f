#pragma once

#include <optional>

#include "accel/kd_tree.h"
#include "mesh/mesh_tree.h"

/// What one might write instead, to be shown where it breaks.
namespace caustic {

/// A descent of the tree that returns the nearest hit of the first cell that has any, without asking whether it lies in
/// that cell: a large triangle may be hit far behind a small one of the next cell.
std::optional<MeshHit> intersectFirstCell(const KdTree& tree, const MeshData& mesh,
                                          const std::vector<std::uint32_t>& triangles, const Ray& ray);

/// A descent that takes the crossing with a plane as exact: a ray that passes a hair beside a triangle's cell, and hits
/// it by rounding, never gets to see it; 0 · ∞ is compared as if it were a number.
std::optional<MeshHit> intersectWithoutSlack(const KdTree& tree, const MeshData& mesh,
                                             const std::vector<std::uint32_t>& triangles, const Ray& ray);

/// All triangles in single precision by Cramer's rule, as many trees keep them.
std::optional<MeshHit> intersectFloat(const MeshData& mesh, const Ray& ray);

}  // namespace caustic
