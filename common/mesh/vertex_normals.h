#pragma once

#include <vector>

#include "mesh/mesh_data.h"

namespace caustic {

/// How much each triangle at a vertex has to say about the normal there.
enum class NormalWeight {
    Mean,   ///< all the same
    Area,   ///< large triangles more
    Angle,  ///< by the angle at the vertex: how the surface around it is cut into triangles doesn't matter
};

/// Unit normals at the mesh's positions, from the triangles around them; zero at a vertex whose triangles cancel or
/// have no area, and at one that no triangle has. A triangle without area adds nothing anywhere.
/// Source: Gouraud 1971 (mean); Thürmer, Wüthrich 1998, Computing Vertex Normals from Polygonal Facets (angle).
std::vector<Vec3> vertexNormals(const MeshData& mesh, NormalWeight weight);

/// The same mesh with these normals in place of its own.
MeshData withVertexNormals(MeshData mesh, NormalWeight weight);

}  // namespace caustic
