#pragma once

#include <cstdint>
#include <filesystem>
#include <iosfwd>

#include "mesh/mesh_data.h"

namespace caustic {

/// How a mesh hangs together. Vertices at the same place count as one.
struct MeshTopology {
    std::size_t edges = 0;
    std::size_t openEdges = 0;       ///< of one triangle
    std::size_t crowdedEdges = 0;    ///< of more than two
    std::size_t turnedEdges = 0;     ///< of two triangles that go round opposite ways
    std::size_t emptyTriangles = 0;  ///< without area

    /// Whether each edge joins two triangles that go round the same way: nothing leaks.
    bool watertight() const { return openEdges + crowdedEdges + turnedEdges == 0; }
};

/// Counts edges by what meets there.
MeshTopology topologyOf(const MeshData& mesh);

/// Writes what a mesh file holds as JSON: counts, bounds, topology, the size of its tree, what building it took and how
/// many rays a second it answers.
/// @throws InputError when the file is no mesh
void inspectMesh(const std::filesystem::path& file, std::uint64_t seed, std::ostream& out);

}  // namespace caustic
