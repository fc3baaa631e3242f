#include "inspect.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <ostream>

#include "core/error.h"
#include "figure/timing.h"
#include "mesh/mesh_file.h"
#include "mesh/mesh_tree.h"
#include "mesh_sets.h"

namespace caustic {

namespace {

using Json = nlohmann::ordered_json;

// For each position the first one at the same place.
std::vector<std::uint32_t> welded(const std::vector<Vec3>& positions) {
    const auto before = [&](std::uint32_t i, std::uint32_t j) {
        return std::lexicographical_compare(positions[i].begin(), positions[i].end(), positions[j].begin(),
                                            positions[j].end());
    };
    std::vector<std::uint32_t> order(positions.size());
    for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
    std::ranges::stable_sort(order, before);
    std::vector<std::uint32_t> first(positions.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        const bool same = i > 0 && !before(order[i - 1], order[i]);
        first[order[i]] = same ? first[order[i - 1]] : order[i];
    }
    return first;
}

Json pointJson(const Vec3& point) { return {point.x(), point.y(), point.z()}; }

double secondsSince(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double megaraysPerSecond(const MeshTree& tree, const Bounds3& box, std::uint64_t seed) {
    Random random(seed, {0});
    std::vector<Ray> rays;
    for (int i = 0; i < 4096; ++i) rays.push_back(randomChord(box, random));
    const auto shoot = [&] {
        for (const Ray& ray : rays) keep(tree.intersect(ray));
    };
    return static_cast<double>(rays.size()) / medianNanoseconds({shoot}, {5, 0.02})[0] * 1e3;
}

}  // namespace

MeshTopology topologyOf(const MeshData& mesh) {
    const std::vector<std::uint32_t> place = welded(mesh.positions);
    // How often an edge is walked from its lower end, and from its higher one.
    std::map<std::array<std::uint32_t, 2>, std::array<std::size_t, 2>> edges;
    MeshTopology topology;
    const std::size_t solid = trianglesWithArea(mesh).size();
    topology.emptyTriangles = mesh.triangles.size() - solid;
    for (const MeshData::Corners& corners : mesh.triangles) {
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t from = place[corners[i]];
            const std::uint32_t to = place[corners[(i + 1) % 3]];
            if (from != to) ++edges[{std::min(from, to), std::max(from, to)}][from < to ? 0 : 1];
        }
    }
    topology.edges = edges.size();
    for (const auto& [ends, walks] : edges) {
        const std::size_t triangles = walks[0] + walks[1];
        if (triangles == 1) ++topology.openEdges;
        if (triangles > 2) ++topology.crowdedEdges;
        if (triangles == 2 && walks[0] != 1) ++topology.turnedEdges;
    }
    return topology;
}

void inspectMesh(const std::filesystem::path& file, std::uint64_t seed, std::ostream& out) {
    const auto mesh = std::make_shared<const MeshData>(loadMesh(file));
    const MeshTopology topology = topologyOf(*mesh);
    const Bounds3 box = boundsOf(*mesh);
    Json json = {{"file", file.string()},
                 {"vertices", mesh->positions.size()},
                 {"unusedVertices", unusedVertices(*mesh)},
                 {"triangles", mesh->triangles.size()},
                 {"normals", mesh->normals.size()},
                 {"textureCoordinates", mesh->uvs.size()},
                 {"bounds", {{"min", pointJson(box.min())}, {"max", pointJson(box.max())}}},
                 {"watertight", topology.watertight()},
                 {"edges", topology.edges},
                 {"openEdges", topology.openEdges},
                 {"crowdedEdges", topology.crowdedEdges},
                 {"turnedEdges", topology.turnedEdges},
                 {"emptyTriangles", topology.emptyTriangles}};
    if (topology.emptyTriangles == mesh->triangles.size()) {
        throw InputError({file.string(), 0}, std::to_string(mesh->triangles.size()) + " triangles",
                         "needs one that has an area");
    }
    Json trees = Json::array();
    for (const MeshTreeKind kind : {MeshTreeKind::SahKdTree, MeshTreeKind::WideKdTree, MeshTreeKind::WideBvh}) {
        const auto start = std::chrono::steady_clock::now();
        const auto tree = plantMeshTree(kind, mesh);
        const double seconds = secondsSince(start);
        const MeshTreeSize size = tree->size();
        trees.push_back({{"tree", name(kind)},
                         {"nodes", size.nodes},
                         {"references", size.references},
                         {"depth", size.depth},
                         {"bytes", size.bytes},
                         {"buildSeconds", seconds},
                         {"megaraysPerSecond", megaraysPerSecond(*tree, box, seed)}});
    }
    json["trees"] = trees;
    out << json.dump(2, ' ', false, Json::error_handler_t::replace) << '\n' << std::flush;
    if (!out) throw InputError({"standard output", 0}, "", "cannot be written; is the disk full?");
}

}  // namespace caustic
