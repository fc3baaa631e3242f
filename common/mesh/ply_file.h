#pragma once

#include <string>
#include <string_view>

#include "mesh/mesh_data.h"

namespace caustic {

/// Reads a mesh from the content of a PLY file, in text or binary of either byte order.
///
/// Vertices: x y z of any type and in any order, with nx ny nz, and with u v, s t or texture_u texture_v where they are
/// given. Faces: lists called vertex_indices or vertex_index, polygons cut into triangles (triangulated), and strips of
/// triangles (element tristrips, -1 begins a new one). Anything else is read and passed over. Text keeps all its digits
/// whatever type the header announces.
/// Source: Turk 1994, The PLY Polygon File Format.
/// @param file  what an error's place is called
/// @throws InputError as parsePlyHeader and PlyData; when there is no vertex, no coordinate of that name or no
/// triangle;
///         for a face of fewer than three corners or with one that names no vertex, and coordinates that aren't finite
MeshData parsePly(std::string_view content, const std::string& file);

}  // namespace caustic
