#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "mesh/mesh_data.h"

namespace caustic {

/// Reads a mesh from the text of a Wavefront OBJ file: `v`, `vt`, `vn` and `f`, with normals and surface coordinates
/// where corners name them. Polygons are cut into triangles (triangulated). Numbers may be negative: they count from
/// the last one that was read. Lines may end in CR LF, go on after a backslash (those four statements; not a comment or
/// a name that ends in one), and be of any length. A number that is too small for a double is 0.
///
/// Everything else is passed over: groups and objects become one mesh, materials belong to scenes, curves and surfaces
/// in free form, points and lines have no triangles. So a material file need not exist. A weight after the three
/// coordinates and a vertex colour are read as numbers and not used.
/// @param file  what an error's place is called
/// @throws InputError with the line: a lone CR; a coordinate that is no finite number, one too few; a face of fewer
/// than three
///         corners, or with a number that is 0 or names nothing; a concave face of more than mostConcaveCorners; and
///         when there is no face at all
MeshData parseObj(std::string_view text, const std::string& file);

/// The same from a file of at most 1 GiB.
/// @throws InputError when it cannot be read, too
MeshData loadObj(const std::filesystem::path& path);

/// The index that a number of a face's corner means: 1 is the first, -1 the last one so far. No number may be 0.
/// @param soFar  how many have been read
/// @return the index, from 0; nothing when the number is 0, points before the first one, or is larger than 2^32 - 2,
///         since indices have 32 bits; a positive one may point to what is still to come
std::optional<std::uint32_t> objIndex(long long number, std::size_t soFar);

}  // namespace caustic
