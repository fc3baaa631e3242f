#include "mesh/gltf_file.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/error.h"
#include "core/text.h"
#include "mesh/gltf_accessor.h"
#include "mesh/gltf_model.h"

namespace caustic {

namespace {

// Nodes may show the same mesh again and again; a small file must not fill the memory.
constexpr std::size_t mostTriangles = std::size_t{1} << 25;

using Affine = Eigen::Transform<Real, 3, Eigen::Affine>;

class SceneReader {
public:
    SceneReader(const tinygltf::Model& model, const std::string& file)
        : model_(model), file_(file), accessors_(model, file), seen_(model.nodes.size()) {}

    // Without recursion: a file decides how deep its nodes go.
    MeshData read() {
        if (model_.scenes.empty()) fail("", "has no scene");
        const auto scene = static_cast<std::size_t>(std::max(model_.defaultScene, 0));
        if (scene >= model_.scenes.size()) fail("scene " + std::to_string(scene), "isn't there");
        std::vector<std::pair<int, Affine>> waiting;
        const auto add = [&](const std::vector<int>& nodes, const Affine& around) {
            for (auto node = nodes.rbegin(); node != nodes.rend(); ++node) waiting.emplace_back(*node, around);
        };
        add(model_.scenes[scene].nodes, Affine::Identity());
        while (!waiting.empty()) {
            const auto [number, around] = waiting.back();
            waiting.pop_back();
            const tinygltf::Node& node = takeNode(number);
            const Affine place = around * transformOf(node, number);
            if (node.mesh >= 0) addMesh(node, place);
            add(node.children, place);
        }
        if (mesh_.triangles.empty()) fail("", "has no triangle");
        if (mesh_.normals.empty()) mesh_.normalCorners.clear();
        if (mesh_.uvs.empty()) mesh_.uvCorners.clear();
        return std::move(mesh_);
    }

private:
    [[noreturn]] void fail(const std::string& value, const std::string& reason) const {
        throw InputError({file_, 0}, value, reason);
    }

    const tinygltf::Node& takeNode(int number) {
        const std::string name = "node " + std::to_string(number);
        if (number < 0 || static_cast<std::size_t>(number) >= model_.nodes.size()) fail(name, "isn't there");
        const auto index = static_cast<std::size_t>(number);
        if (seen_[index]) fail(name, "is reached twice; nodes must be a tree");
        seen_[index] = true;
        const tinygltf::Node& node = model_.nodes[index];
        if (node.skin >= 0) fail(name, "has a skin, which is not followed here; apply it before exporting");
        if (node.extensions.contains("EXT_mesh_gpu_instancing"))
            fail(name, "has EXT_mesh_gpu_instancing, which is not followed here");
        return node;
    }

    // 3.5.3: a matrix by columns, or translation, rotation (x y z w) and scale.
    Affine transformOf(const tinygltf::Node& node, int number) const {
        Affine transform = Affine::Identity();
        const auto given = [&](const std::vector<double>& values, const char* name, std::size_t size) {
            if (!values.empty() && values.size() != size) {
                fail("node " + std::to_string(number), std::string("has a ") + name + " of " +
                                                           std::to_string(values.size()) + " numbers in place of " +
                                                           std::to_string(size));
            }
            return !values.empty();
        };
        if (given(node.matrix, "matrix", 16)) {
            for (std::size_t i = 0; i < 16; ++i)
                transform.matrix()(static_cast<Eigen::Index>(i % 4), static_cast<Eigen::Index>(i / 4)) = node.matrix[i];
        } else {
            const auto& t = node.translation;
            const auto& r = node.rotation;
            const auto& s = node.scale;
            if (given(t, "translation", 3)) transform.translate(Vec3(t[0], t[1], t[2]));
            if (given(r, "rotation", 4)) transform.rotate(Eigen::Quaternion<Real>(r[3], r[0], r[1], r[2]).normalized());
            if (given(s, "scale", 3)) transform.scale(Vec3(s[0], s[1], s[2]));
        }
        const bool affine = transform.matrix().row(3) == Eigen::RowVector4d(0, 0, 0, 1);
        if (!affine || !transform.matrix().allFinite())
            fail("node " + std::to_string(number), "has a transform that is not affine or not finite");
        return transform;
    }

    void addMesh(const tinygltf::Node& node, const Affine& place) {
        if (static_cast<std::size_t>(node.mesh) >= model_.meshes.size())
            fail("mesh " + std::to_string(node.mesh), "isn't there");
        const tinygltf::Mesh& mesh = model_.meshes[static_cast<std::size_t>(node.mesh)];
        for (const std::vector<double>* weights : {&mesh.weights, &node.weights}) {
            if (std::ranges::any_of(*weights, [](double weight) { return weight != 0; }))
                fail("mesh " + std::to_string(node.mesh),
                     "has morph targets with weights, which are not followed here");
        }
        for (const tinygltf::Primitive& primitive : mesh.primitives) {
            if (primitive.mode >= TINYGLTF_MODE_TRIANGLES || primitive.mode < 0) addPrimitive(primitive, place);
        }
    }

    // The values of an attribute as vectors; empty when the primitive doesn't have it.
    template <typename Vector>
    std::vector<Vector> attribute(const tinygltf::Primitive& primitive, const char* name) const {
        const auto found = primitive.attributes.find(name);
        if (found == primitive.attributes.end()) return {};
        constexpr std::size_t size = Vector::RowsAtCompileTime;
        const std::vector<Real> values = accessors_.values(found->second, size);
        std::vector<Vector> vectors(values.size() / size);
        for (std::size_t i = 0; i < values.size(); ++i)
            vectors[i / size][static_cast<Eigen::Index>(i % size)] = values[i];
        return vectors;
    }

    void addPrimitive(const tinygltf::Primitive& primitive, const Affine& place) {
        const auto positions = attribute<Vec3>(primitive, "POSITION");
        const auto normals = attribute<Vec3>(primitive, "NORMAL");
        const auto uvs = attribute<Vec2>(primitive, "TEXCOORD_0");
        if (positions.empty()) fail("POSITION", "is missing from a primitive");
        for (const std::size_t size : {normals.size(), uvs.size()}) {
            if (size != 0 && size != positions.size()) fail(std::to_string(size), "must be as many as positions");
        }
        const Eigen::Matrix3d linear = place.linear();
        const bool mirrored = linear.determinant() < 0;
        addTriangles(primitive, positions.size(), {!normals.empty(), !uvs.empty(), mirrored});
        for (const Vec3& position : positions) mesh_.positions.push_back(place * position);
        // Normals by the cofactors: the inverse's transpose times the determinant, whose sign alone matters.
        Eigen::Matrix3d cofactors;
        for (int i = 0; i < 3; ++i) cofactors.col(i) = linear.col((i + 1) % 3).cross(linear.col((i + 2) % 3));
        for (const Vec3& normal : normals) mesh_.normals.push_back((mirrored ? -1 : 1) * (cofactors * normal));
        for (const Vec2& uv : uvs) mesh_.uvs.emplace_back(uv.x(), 1 - uv.y());
    }

    struct Extras {
        bool normals;
        bool uvs;
        bool mirrored;
    };

    void addTriangles(const tinygltf::Primitive& primitive, std::size_t vertices, const Extras& extras) {
        const std::vector<std::uint32_t> indices = indicesOf(primitive, vertices);
        const int mode = primitive.mode < 0 ? TINYGLTF_MODE_TRIANGLES : primitive.mode;
        if (mode > TINYGLTF_MODE_TRIANGLE_FAN) fail(std::to_string(mode), "is no mode of a primitive");
        const bool list = mode == TINYGLTF_MODE_TRIANGLES;
        if (list && indices.size() % 3 != 0) fail(std::to_string(indices.size()), "must be three for each triangle");
        const std::size_t count = list ? indices.size() / 3 : std::max<std::size_t>(indices.size(), 2) - 2;
        if (count > mostTriangles - mesh_.triangles.size()) fail("", "has more triangles than can be held");
        const auto shifted = [](const MeshData::Corners& corners, std::size_t by, bool there) {
            MeshData::Corners moved = {MeshData::none, MeshData::none, MeshData::none};
            for (std::size_t k = 0; k < 3 && there; ++k) moved[k] = corners[k] + static_cast<std::uint32_t>(by);
            return moved;
        };
        for (std::size_t i = 0; i < count; ++i) {
            // 3.7.2.1.
            MeshData::Corners c = {indices[list ? 3 * i : i], 0, 0};
            if (list) {
                c = {c[0], indices[3 * i + 1], indices[3 * i + 2]};
            } else if (mode == TINYGLTF_MODE_TRIANGLE_STRIP) {
                c = {c[0], indices[i + 1 + i % 2], indices[i + 2 - i % 2]};
            } else {
                c = {indices[i + 1], indices[i + 2], indices[0]};
            }
            if (extras.mirrored) std::swap(c[1], c[2]);
            mesh_.triangles.push_back(shifted(c, mesh_.positions.size(), true));
            mesh_.normalCorners.push_back(shifted(c, mesh_.normals.size(), extras.normals));
            mesh_.uvCorners.push_back(shifted(c, mesh_.uvs.size(), extras.uvs));
        }
    }

    std::vector<std::uint32_t> indicesOf(const tinygltf::Primitive& primitive, std::size_t vertices) const {
        std::vector<std::uint32_t> indices;
        if (primitive.indices < 0) {
            for (std::uint32_t i = 0; i < vertices; ++i) indices.push_back(i);
            return indices;
        }
        for (const Real value : accessors_.values(primitive.indices, 1)) {
            if (!(value >= 0 && value < static_cast<Real>(vertices)) || value != std::floor(value)) {
                accessors_.fail(primitive.indices, formatReal(value),
                                "has an index that names no vertex; there are " + std::to_string(vertices));
            }
            indices.push_back(static_cast<std::uint32_t>(value));
        }
        return indices;
    }

    const tinygltf::Model& model_;
    const std::string& file_;
    GltfAccessors accessors_;
    std::vector<bool> seen_;
    MeshData mesh_;
};

}  // namespace

MeshData parseGltf(std::string_view content, const std::filesystem::path& path) {
    const tinygltf::Model model = loadGltfModel(content, path);
    return SceneReader(model, path.string()).read();
}

}  // namespace caustic
