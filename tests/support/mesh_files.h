#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "mesh/mesh_data.h"

namespace caustic::test {

/// A closed body of polygons, counterclockwise seen from outside.
struct Polyhedron {
    std::vector<Vec3> vertices;
    std::vector<std::vector<std::uint32_t>> faces;
};

/// A prism over an L of 3 by 2 with legs 1 wide, 5 high: two concave hexagons and six rectangles. Times scale, its
/// volume is 20 scale³ and its area 58 scale². It lies off the origin, and coordinates are rounded to float.
Polyhedron lPrism(Real scale);

/// The volume that a mesh's triangles enclose: negative when they face inwards.
Real volumeOf(const MeshData& mesh);

/// The area of a mesh's triangles.
Real areaOf(const MeshData& mesh);

/// The body in OBJ, with the shortest decimals that read back as the same double.
std::string objOf(const Polyhedron& body);

/// How a PLY file is written.
struct PlyStyle {
    enum class Format { Text, Little, Big };
    Format format = Format::Text;
    std::string coordinateType = "float";
    std::string countType = "uchar";
    std::string indexType = "int";
    std::string order = "xyz";  ///< of the coordinates
    bool crlf = false;          ///< in the header
    bool extras = false;        ///< comments, obj_info, properties and elements that a mesh has no use for
};

/// The body in PLY.
std::string plyOf(const Polyhedron& body, const PlyStyle& style);

/// The body's triangles (as our own reader cuts its polygons) in STL; `name` follows "solid", or fills the header.
std::string stlTextOf(const MeshData& mesh, const std::string& name);
std::string stlBinaryOf(const MeshData& mesh, const std::string& header);

/// A number's bytes.
/// @param type  as PLY calls it
std::string bytesOf(Real value, const std::string& type, bool bigEndian = false);

}  // namespace caustic::test
