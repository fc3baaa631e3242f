#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/random.h"
#include "math/vector.h"

namespace caustic {

/// A closed surface of triangles, each edge shared by exactly two.
struct ClosedMesh {
    std::vector<Vec3> vertices;
    std::vector<std::array<int, 3>> triangles;        ///< vertex numbers, counterclockwise seen from outside
    std::vector<std::array<int, 2>> edges;            ///< vertex numbers
    std::vector<std::array<int, 2>> trianglesOfEdge;  ///< the two at each edge
    std::vector<std::vector<int>> trianglesOfVertex;  ///< the fan around each vertex
    Vec3 center = Vec3::Zero();                       ///< a point strictly inside
    std::array<Vec3, 3> insideAxes = {Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};  ///< of an ellipsoid around it, inside

    /// The triangle's corners.
    std::array<Vec3, 3> corners(int triangle) const;

    /// A point strictly inside, at least a tenth of the way off the surface.
    Vec3 pointInside(Random& random) const;
};

/// A bumpy closed mesh of 80 triangles: an icosahedron's subdivision with a random radius at each vertex, stretched by
/// up to 10, turned, and moved away from the coordinates' origin. No two are alike.
/// @param away  how far, in its sizes; between 0.01 and 100 at random by default
ClosedMesh randomClosedMesh(Random& random, std::optional<Real> away = std::nullopt);

}  // namespace caustic
