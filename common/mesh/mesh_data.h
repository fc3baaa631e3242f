#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "math/bounds.h"
#include "math/vector.h"

namespace caustic {

/// A triangle mesh as files have it: corners name positions, normals and surface coordinates apart from each other, so
/// that a seam in one need not be a seam in the others.
struct MeshData {
    /// Numbers of a triangle's three corners, counterclockwise seen from outside.
    using Corners = std::array<std::uint32_t, 3>;

    /// Stands for a normal or a uv that a corner doesn't have.
    static constexpr std::uint32_t none = 0xffffffffU;

    std::vector<Vec3> positions;     ///< of the corners
    std::vector<Corners> triangles;  ///< by numbers of positions

    std::vector<Vec3> normals;           ///< of any length; a zero one counts as none
    std::vector<Corners> normalCorners;  ///< empty, or one for each triangle

    std::vector<Vec2> uvs;           ///< surface coordinates
    std::vector<Corners> uvCorners;  ///< empty, or one for each triangle

    /// The positions of a triangle's corners.
    std::array<Vec3, 3> corners(std::uint32_t triangle) const {
        const Corners& c = triangles[triangle];
        return {positions[c[0]], positions[c[1]], positions[c[2]]};
    }

    /// A box around a triangle.
    Bounds3 bounds(std::uint32_t triangle) const {
        const auto [a, b, c] = corners(triangle);
        return {a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c)};
    }
};

/// Throws InputError unless there is a triangle, every number names something that is there, and every coordinate is
/// finite.
void checkMesh(const MeshData& mesh);

/// The box around all triangles. A vertex that none of them uses doesn't count.
Bounds3 boundsOf(const MeshData& mesh);

/// How many positions no triangle uses.
std::size_t unusedVertices(const MeshData& mesh);

/// (b - a) × (c - a): twice the area, along the normal.
Vec3 twiceArea(const MeshData& mesh, std::uint32_t triangle);

/// The triangles whose area is not zero: those that can be hit.
std::vector<std::uint32_t> trianglesWithArea(const MeshData& mesh);

}  // namespace caustic
