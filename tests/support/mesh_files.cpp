#include "support/mesh_files.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "core/text.h"

namespace caustic::test {

namespace {

template <typename T>
std::string bytesAs(Real value, bool bigEndian) {
    const T number = static_cast<T>(value);
    std::string bytes(reinterpret_cast<const char*>(&number), sizeof(T));
    if (bigEndian) std::ranges::reverse(bytes);
    return bytes;
}

Real rounded(Real value) { return static_cast<Real>(static_cast<float>(value)); }

std::string words(const Vec3& v) { return formatReal(v.x()) + " " + formatReal(v.y()) + " " + formatReal(v.z()); }

}  // namespace

Polyhedron lPrism(Real scale) {
    const std::vector<Vec2> outline = {{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 2}, {0, 2}};
    const Vec3 offset(0.25, -1.5, 0.125);
    Polyhedron body;
    for (const Real height : {0.0, 5.0}) {
        for (const Vec2& corner : outline) {
            const Vec3 vertex = scale * (Vec3(corner.x(), corner.y(), height) + offset);
            body.vertices.emplace_back(rounded(vertex.x()), rounded(vertex.y()), rounded(vertex.z()));
        }
    }
    body.faces = {{5, 4, 3, 2, 1, 0}, {6, 7, 8, 9, 10, 11}};
    for (std::uint32_t i = 0; i < 6; ++i) {
        const std::uint32_t next = (i + 1) % 6;
        body.faces.push_back({i, next, next + 6, i + 6});
    }
    return body;
}

Real volumeOf(const MeshData& mesh) {
    Real sum = 0;
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
        const auto [a, b, c] = mesh.corners(i);
        const Vec3 from = mesh.positions[mesh.triangles[0][0]];
        sum += (a - from).dot((b - from).cross(c - from));
    }
    return sum / 6;
}

Real areaOf(const MeshData& mesh) {
    Real sum = 0;
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) sum += twiceArea(mesh, i).norm() / 2;
    return sum;
}

std::string objOf(const Polyhedron& body) {
    std::string text;
    for (const Vec3& vertex : body.vertices) text += "v " + words(vertex) + "\n";
    for (const auto& face : body.faces) {
        text += "f";
        for (const std::uint32_t corner : face) text += " " + std::to_string(corner + 1);
        text += "\n";
    }
    return text;
}

std::string bytesOf(Real value, const std::string& type, bool bigEndian) {
    if (type == "char") return bytesAs<std::int8_t>(value, bigEndian);
    if (type == "uchar") return bytesAs<std::uint8_t>(value, bigEndian);
    if (type == "short") return bytesAs<std::int16_t>(value, bigEndian);
    if (type == "ushort") return bytesAs<std::uint16_t>(value, bigEndian);
    if (type == "int") return bytesAs<std::int32_t>(value, bigEndian);
    if (type == "uint") return bytesAs<std::uint32_t>(value, bigEndian);
    return type == "float" ? bytesAs<float>(value, bigEndian) : bytesAs<double>(value, bigEndian);
}

std::string plyOf(const Polyhedron& body, const PlyStyle& style) {
    using Format = PlyStyle::Format;
    const bool text = style.format == Format::Text;
    const char* const name = text                          ? "ascii"
                             : style.format == Format::Big ? "binary_big_endian"
                                                           : "binary_little_endian";
    std::string header = std::string("ply\nformat ") + name + " 1.0\n";
    if (style.extras) header += "comment there is no end_header here\nobj_info num_cols 7\n";
    header += "element vertex " + std::to_string(body.vertices.size()) + "\n";
    if (style.extras) header += "property uchar red\nproperty list short double weights\n";
    for (const char axis : style.order) header += "property " + style.coordinateType + " " + axis + "\n";
    if (style.extras) header += "element edge 1\nproperty int vertex1\n";
    header += "element face " + std::to_string(body.faces.size()) + "\n";
    if (style.extras) header += "property float quality\n";
    header += "property list " + style.countType + " " + style.indexType + " vertex_indices\nend_header\n";
    if (style.crlf) {
        for (std::size_t at = header.find('\n'); at != std::string::npos; at = header.find('\n', at + 2))
            header.insert(at, "\r");
    }
    std::string data;
    const auto write = [&](Real value, const std::string& type) {
        data += text ? formatReal(value) + " " : bytesOf(value, type, style.format == Format::Big);
    };
    const auto endLine = [&] { data += text ? "\n" : ""; };
    for (const Vec3& vertex : body.vertices) {
        if (style.extras) {
            write(200, "uchar");
            write(2, "short");
            for (const Real weight : {0.5, -0.25}) write(weight, "double");
        }
        for (const char axis : style.order) write(vertex[axis - 'x'], style.coordinateType);
        endLine();
    }
    if (style.extras) {
        write(-7, "int");
        endLine();
    }
    for (const auto& face : body.faces) {
        if (style.extras) write(0.75, "float");
        write(static_cast<Real>(face.size()), style.countType);
        for (const std::uint32_t corner : face) write(corner, style.indexType);
        endLine();
    }
    return header + data;
}

std::string stlTextOf(const MeshData& mesh, const std::string& name) {
    std::string text = "solid " + name + "\n";
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
        text += "facet normal 0 0 0\n outer loop\n";
        for (const Vec3& corner : mesh.corners(i)) text += "  vertex " + words(corner) + "\n";
        text += " endloop\nendfacet\n";
    }
    return text + "endsolid " + name + "\n";
}

std::string stlBinaryOf(const MeshData& mesh, const std::string& header) {
    std::string data = header;
    data.resize(80, '\0');
    data += bytesOf(static_cast<Real>(mesh.triangles.size()), "uint");
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
        data += std::string(12, '\0');
        for (const Vec3& corner : mesh.corners(i)) {
            for (const Real coordinate : corner) data += bytesOf(coordinate, "float");
        }
        data += std::string(2, '\0');
    }
    return data;
}

}  // namespace caustic::test
