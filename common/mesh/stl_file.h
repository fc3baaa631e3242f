#pragma once

#include <string>
#include <string_view>

#include "mesh/mesh_data.h"

namespace caustic {

/// Reads a mesh from the content of an STL file, binary or text; several solids become one mesh.
///
/// A file is binary when its size is what its number of facets asks for, whatever its first word: many binary files
/// begin with "solid". Corners at exactly the same place become one vertex, for STL lists triangles without their
/// neighbours; no others are joined. Normals of facets are not used: the order of corners says which side is outside.
/// Source: 3D Systems 1989, StereoLithography Interface Specification.
/// @param file  what an error's place is called
/// @throws InputError when it is cut short or holds more than it announces; with the line in a text, when something
/// else
///         stands where a keyword or a number must; when there is no facet, or a coordinate is not finite
MeshData parseStl(std::string_view content, const std::string& file);

}  // namespace caustic
