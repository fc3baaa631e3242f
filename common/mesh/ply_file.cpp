#include "mesh/ply_file.h"

#include <array>
#include <cmath>
#include <optional>
#include <span>

#include "core/error.h"
#include "core/text.h"
#include "mesh/ply_data.h"
#include "mesh/ply_header.h"
#include "mesh/polygon.h"

namespace caustic {

namespace {

using Columns = std::vector<std::size_t>;  // numbers of properties

class PlyReader {
public:
    PlyReader(std::string_view content, const std::string& file)
        : file_(file), header_(parsePlyHeader(content, file)), data_(content, header_, file) {}

    MeshData read() {
        for (const PlyElement& element : header_.elements) {
            if (element.name == "vertex") {
                readVertices(element);
            } else if (element.name == "face" || element.name == "tristrips") {
                readLists(element);
            } else {
                passOver(element);
            }
        }
        data_.checkEnd();
        // Faces may come before the vertices that they name.
        std::size_t first = 0;
        for (const std::uint32_t size : faceSizes_) {
            addPolygon(std::span(faceCorners_).subspan(first, size));
            first += size;
        }
        for (const MeshData::Corners& corners : stripTriangles_) addTriangle(corners);
        if (mesh_.triangles.empty()) throw InputError({file_, 0}, "", "has no face");
        return std::move(mesh_);
    }

private:
    // The properties of these names; nothing unless all are there, each a single value.
    static std::optional<Columns> columnsOf(const PlyElement& element, std::initializer_list<const char*> names) {
        Columns columns;
        for (const char* name : names) {
            const auto found = element.find(name);
            if (!found || element.properties[*found].countType) return std::nullopt;
            columns.push_back(*found);
        }
        return columns;
    }

    static std::optional<Columns> uvColumns(const PlyElement& element) {
        for (const auto& names : {std::array{"u", "v"}, std::array{"s", "t"}, std::array{"texture_u", "texture_v"}}) {
            if (const auto columns = columnsOf(element, {names[0], names[1]})) return columns;
        }
        return std::nullopt;
    }

    void readVertices(const PlyElement& element) {
        const auto position = columnsOf(element, {"x", "y", "z"});
        const auto normal = columnsOf(element, {"nx", "ny", "nz"});
        const auto uv = uvColumns(element);
        if (!position) throw InputError({file_, 0}, "vertex", "needs properties x, y and z");
        std::vector<Real> row(element.properties.size());
        for (std::uint64_t i = 0; i < element.count; ++i) {
            for (std::size_t k = 0; k < row.size(); ++k) {
                const std::vector<Real>& values = data_.next(element.properties[k], element.name, i);
                row[k] = values.empty() ? 0 : values.front();
            }
            const auto vector = [&](const Columns& c) { return Vec3(row[c[0]], row[c[1]], row[c[2]]); };
            for (const std::size_t column : *position) {
                if (!std::isfinite(row[column])) data_.fail(formatReal(row[column]), "must be finite");
            }
            mesh_.positions.push_back(vector(*position));
            if (normal) mesh_.normals.push_back(vector(*normal));
            if (uv) mesh_.uvs.emplace_back(row[(*uv)[0]], row[(*uv)[1]]);
        }
    }

    void readLists(const PlyElement& element) {
        const auto indices = element.find("vertex_indices");
        const auto column = indices ? indices : element.find("vertex_index");
        const bool isList = column && element.properties[*column].countType.has_value();
        if (!isList || isReal(element.properties[*column].type))
            throw InputError({file_, 0}, element.name, "needs a list of integers vertex_indices");
        for (std::uint64_t i = 0; i < element.count; ++i) {
            for (std::size_t k = 0; k < element.properties.size(); ++k) {
                const std::vector<Real>& values = data_.next(element.properties[k], element.name, i);
                if (k != *column) continue;
                if (element.name == "face") {
                    takeFace(values);
                } else {
                    takeStrip(values);
                }
            }
        }
    }

    void passOver(const PlyElement& element) {
        for (std::uint64_t i = 0; i < element.count && !element.properties.empty(); ++i) {
            for (const PlyProperty& property : element.properties) data_.next(property, element.name, i);
        }
    }

    // How many vertices there are, wherever in the file they stand.
    std::uint64_t vertexCount() const {
        for (const PlyElement& element : header_.elements) {
            if (element.name == "vertex") return element.count;
        }
        return 0;
    }

    std::uint32_t cornerOf(Real value) const {
        if (!(value >= 0 && value < static_cast<Real>(vertexCount())) || value >= Real(MeshData::none)) {
            data_.fail(formatReal(value),
                       "names a vertex that isn't there; there are " + std::to_string(vertexCount()));
        }
        return static_cast<std::uint32_t>(value);
    }

    void takeFace(const std::vector<Real>& values) {
        if (values.size() < 3) data_.fail(std::to_string(values.size()) + " corners", "a face needs at least three");
        for (const Real value : values) faceCorners_.push_back(cornerOf(value));
        faceSizes_.push_back(static_cast<std::uint32_t>(values.size()));
    }

    // Every other triangle of a strip goes round the other way; one that names a vertex twice only leads elsewhere.
    void takeStrip(const std::vector<Real>& values) {
        std::vector<std::uint32_t> strip;
        for (const Real value : values) {
            if (value == -1) {
                strip.clear();
                continue;
            }
            strip.push_back(cornerOf(value));
            const std::size_t n = strip.size();
            if (n < 3) continue;
            const bool turned = n % 2 == 0;
            const MeshData::Corners c = {strip[n - (turned ? 2 : 3)], strip[n - (turned ? 3 : 2)], strip[n - 1]};
            if (c[0] != c[1] && c[1] != c[2] && c[2] != c[0]) stripTriangles_.push_back(c);
        }
    }

    void addPolygon(std::span<const std::uint32_t> corners) {
        if (corners.size() == 3) return addTriangle({corners[0], corners[1], corners[2]});
        std::vector<Vec3> places;
        places.reserve(corners.size());
        for (const std::uint32_t corner : corners) places.push_back(mesh_.positions[corner]);
        if (places.size() > mostConcaveCorners && !isConvex(places)) {
            throw InputError({file_, 0}, std::to_string(places.size()) + " corners",
                             "a concave face may have at most " + std::to_string(mostConcaveCorners));
        }
        for (const auto& [a, b, c] : triangulated(places)) addTriangle({corners[a], corners[b], corners[c]});
    }

    void addTriangle(const MeshData::Corners& corners) {
        mesh_.triangles.push_back(corners);
        if (!mesh_.normals.empty()) mesh_.normalCorners.push_back(corners);
        if (!mesh_.uvs.empty()) mesh_.uvCorners.push_back(corners);
    }

    const std::string& file_;
    PlyHeader header_;
    PlyData data_;
    MeshData mesh_;
    std::vector<std::uint32_t> faceCorners_;  // of all faces, one after the other
    std::vector<std::uint32_t> faceSizes_;
    std::vector<MeshData::Corners> stripTriangles_;
};

}  // namespace

MeshData parsePly(std::string_view content, const std::string& file) { return PlyReader(content, file).read(); }

}  // namespace caustic
