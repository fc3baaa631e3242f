#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "failures/fragile_methods.h"
#include "figure/failures.h"
#include "figures.h"
#include "mesh/kd_mesh_tree.h"
#include "mesh/polygon.h"
#include "mesh/vertex_normals.h"
#include "mesh_sets.h"

namespace caustic {

namespace {

using Intersect = std::function<std::optional<MeshHit>(const Ray&)>;

struct TreeMethod {
    std::string name;
    Intersect intersect;
    bool robust = false;
};

// Every method on one mesh, the fragile ones first.
std::vector<TreeMethod> treeMethods(const std::shared_ptr<const MeshData>& mesh) {
    const auto plain = std::make_shared<KdMeshTree>(mesh, KdRule{});
    const auto triangles = std::make_shared<std::vector<std::uint32_t>>(trianglesWithArea(*mesh));
    std::vector<TreeMethod> methods = {
        {"stops at the first cell with a hit",
         [=](const Ray& ray) { return intersectFirstCell(plain->tree(), *mesh, *triangles, ray); }},
        {"crossings taken as exact",
         [=](const Ray& ray) { return intersectWithoutSlack(plain->tree(), *mesh, *triangles, ray); }},
        {"triangles in single precision", [=](const Ray& ray) { return intersectFloat(*mesh, ray); }}};
    for (const MeshTreeKind kind :
         {MeshTreeKind::MedianKdTree, MeshTreeKind::SahKdTree, MeshTreeKind::WideKdTree, MeshTreeKind::WideBvh}) {
        const std::shared_ptr<const MeshTree> tree = plantMeshTree(kind, mesh);
        methods.push_back({name(kind), [tree](const Ray& ray) { return tree->intersect(ray); }, true});
    }
    return methods;
}

// Exact ties aside: two triangles at the same t are both right.
bool agree(const std::optional<MeshHit>& found, const std::optional<MeshHit>& truth) {
    if (found.has_value() != truth.has_value()) return false;
    return !found || found->triangle == truth->triangle || found->t == truth->t;
}

FailureKind raysAt(const MeshSet& set, std::uint64_t seed) {
    Random maker(seed, {0});
    const auto mesh = std::make_shared<const MeshData>(set.make(maker, 300));
    FailureKind kind = {"triangles: " + set.name, {}, nullptr};
    const std::vector<TreeMethod> methods = treeMethods(mesh);
    for (const TreeMethod& method : methods) kind.methods.push_back({method.name, method.robust});
    kind.right = [mesh, methods, box = boundsOf(*mesh),
                  brute = std::make_shared<BruteForceMesh>(mesh)](Random& random) {
        const Ray ray = randomRayAt(*mesh, box, random);
        const auto truth = brute->intersect(ray);
        std::vector<bool> right;
        for (const TreeMethod& method : methods) right.push_back(agree(method.intersect(ray), truth));
        return right;
    };
    return kind;
}

// A star-shaped polygon with concave corners, in a plane of any direction.
std::vector<Vec3> concavePolygon(Random& random) {
    const std::size_t count = 5 + random.below(8);
    const Vec3 x = Vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(0.5, 1)).normalized();
    const Vec3 y = x.cross(Vec3(0.3, 0.9, -0.2)).normalized();
    std::vector<Vec3> corners;
    for (std::size_t i = 0; i < count; ++i) {
        const Real angle = 2 * std::numbers::pi * static_cast<Real>(i) / static_cast<Real>(count);
        const Real radius = i % 2 == 0 ? 1 : random.uniform(0.1, 0.5);
        corners.push_back(radius * (std::cos(angle) * x + std::sin(angle) * y));
    }
    return corners;
}

// The sum of the triangles' areas is the polygon's only if they don't overlap.
template <typename Triangles>
bool covers(const std::vector<Vec3>& corners, const Triangles& triangles) {
    Vec3 whole = Vec3::Zero();
    for (std::size_t i = 0; i < corners.size(); ++i) whole += corners[i].cross(corners[(i + 1) % corners.size()]);
    Real sum = 0;
    for (const auto& [a, b, c] : triangles) {
        sum += (corners[b] - corners[a]).cross(corners[c] - corners[a]).norm();
    }
    return std::abs(sum - whole.norm()) <= 1e-9 * whole.norm();
}

std::vector<bool> cutsPolygons(Random& random) {
    const std::vector<Vec3> corners = concavePolygon(random);
    std::vector<std::array<std::uint32_t, 3>> fan;
    for (std::uint32_t k = 2; k < corners.size(); ++k) fan.push_back({0, k - 1, k});
    return {covers(corners, fan), covers(corners, triangulated(corners))};
}

// A box whose faces are cut along one diagonal or the other: by symmetry the normal at a corner is along the three
// faces' sum, whichever diagonals were taken.
std::vector<bool> findsCornerNormals(Random& random) {
    MeshData mesh;
    const Vec3 size(random.uniform(0.5, 2), random.uniform(0.5, 2), random.uniform(0.5, 2));
    for (int k = 0; k < 8; ++k) {
        mesh.positions.push_back(Vec3(k & 1 ? 1 : 0, k & 2 ? 1 : 0, k & 4 ? 1 : 0).cwiseProduct(size));
    }
    constexpr std::array<std::array<std::uint32_t, 4>, 6> faces = {
        {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
    for (const auto& [a, b, c, d] : faces) {
        if (random.below(2) == 0) {
            mesh.triangles.insert(mesh.triangles.end(), {{a, b, c}, {a, c, d}});
        } else {
            mesh.triangles.insert(mesh.triangles.end(), {{a, b, d}, {b, c, d}});
        }
    }
    const auto corner = static_cast<std::size_t>(random.below(8));
    Vec3 truth;
    for (int axis = 0; axis < 3; ++axis) truth[axis] = (corner >> axis & 1) == 1 ? 1 : -1;
    std::vector<bool> right;
    for (const NormalWeight weight : {NormalWeight::Mean, NormalWeight::Area, NormalWeight::Angle})
        right.push_back((vertexNormals(mesh, weight)[corner] - truth.normalized()).norm() <= 1e-9);
    return right;
}

}  // namespace

void chartFailures(FigureContext& context) {
    std::vector<FailureKind> kinds;
    for (const MeshSet& set : meshSets()) kinds.push_back(raysAt(set, context.seed()));
    std::vector<FailureRow> rows = countFailures(kinds, FailureTrials::of(context, context.byQuality(5'000, 100'000)));
    const std::vector<FailureRow> more =
        countFailures({{"concave polygons", {{"fan around the first corner"}, {"ears", true}}, cutsPolygons},
                       {"corner of a box",
                        {{"normals: mean"}, {"normals: by area"}, {"normals: by angle", true}},
                        findsCornerNormals}},
                      FailureTrials::of(context, 10'000));
    rows.insert(rows.end(), more.begin(), more.end());
    drawFailureMarks(rows, context);
}

}  // namespace caustic
