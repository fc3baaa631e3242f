#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/random.h"
#include "math/ray.h"
#include "mesh/mesh_data.h"

namespace caustic {

/// A way to make triangles that trees may stumble over.
struct MeshSet {
    std::string name;  ///< as tables call it
    /// At most `triangles` of them.
    MeshData (*make)(Random& random, std::uint32_t triangles);
};

/// Triangles anywhere; all in one plane; in identical boxes; one huge among many tiny; slivers; each one twice; corners
/// on a grid, so that planes of the tree run through them; far from the coordinates' origin.
std::vector<MeshSet> meshSets();

/// A rectangular grid over a bumpy sphere, two triangles a cell, `triangles` or a few less: what a scanned model is
/// like.
MeshData bumpySphere(std::uint32_t triangles);

/// A ray at a mesh: any direction, at a vertex, at a point of an edge, or along an axis in the plane of a vertex, where
/// the planes of a tree are.
Ray randomRayAt(const MeshData& mesh, const Bounds3& box, Random& random);

/// A ray from outside of the box through two random points of it.
Ray randomChord(const Bounds3& box, Random& random);

}  // namespace caustic
