#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "core/parallel.h"
#include "core/progress.h"
#include "failures/fragile_methods.h"
#include "figure/csv_table.h"
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
        methods.push_back({name(kind), [tree](const Ray& ray) { return tree->intersect(ray); }});
    }
    return methods;
}

// Exact ties aside: two triangles at the same t are both right.
bool agree(const std::optional<MeshHit>& found, const std::optional<MeshHit>& truth) {
    if (found.has_value() != truth.has_value()) return false;
    return !found || found->triangle == truth->triangle || found->t == truth->t;
}

void addMeshSet(CsvTable& table, const MeshSet& set, FigureContext& context) {
    Random maker(context.seed(), {0});
    const auto mesh = std::make_shared<const MeshData>(set.make(maker, 300));
    const Bounds3 box = boundsOf(*mesh);
    const BruteForceMesh brute(mesh);
    const std::vector<TreeMethod> methods = treeMethods(mesh);
    const std::int64_t rays = context.byQuality(5'000, 100'000);
    constexpr std::int64_t batch = 1000;
    std::vector<std::vector<std::int64_t>> failures(methods.size(), std::vector<std::int64_t>(rays / batch, 0));
    parallelFor(rays / batch, context.threads(), [&](std::int64_t part) {
        for (std::int64_t i = part * batch; i < (part + 1) * batch; ++i) {
            Random random(context.seed(), {1, static_cast<std::uint64_t>(i)});
            const Ray ray = randomRayAt(*mesh, box, random);
            const auto truth = brute.intersect(ray);
            for (std::size_t k = 0; k < methods.size(); ++k) {
                if (!agree(methods[k].intersect(ray), truth)) ++failures[k][static_cast<std::size_t>(part)];
            }
        }
    });
    for (std::size_t k = 0; k < methods.size(); ++k) {
        std::int64_t sum = 0;
        for (const std::int64_t count : failures[k]) sum += count;
        table.addRow(methods[k].name, "triangles: " + set.name, sum, rays);
    }
    context.progress().advance();
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

void addPolygons(CsvTable& table, FigureContext& context) {
    constexpr int trials = 10'000;
    int fans = 0;
    int ears = 0;
    for (int i = 0; i < trials; ++i) {
        Random random(context.seed(), {2, static_cast<std::uint64_t>(i)});
        const std::vector<Vec3> corners = concavePolygon(random);
        std::vector<std::array<std::uint32_t, 3>> fan;
        for (std::uint32_t k = 2; k < corners.size(); ++k) fan.push_back({0, k - 1, k});
        fans += covers(corners, fan) ? 0 : 1;
        ears += covers(corners, triangulated(corners)) ? 0 : 1;
    }
    table.addRow("fan around the first corner", "concave polygons", fans, trials);
    table.addRow("ears", "concave polygons", ears, trials);
    context.progress().advance();
}

// A box whose faces are cut along one diagonal or the other: by symmetry the normal at a corner is along the three
// faces' sum, whichever diagonals were taken.
void addCorners(CsvTable& table, FigureContext& context) {
    constexpr int trials = 10'000;
    std::array<int, 3> failures = {0, 0, 0};
    for (int i = 0; i < trials; ++i) {
        Random random(context.seed(), {3, static_cast<std::uint64_t>(i)});
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
        constexpr std::array weights = {NormalWeight::Mean, NormalWeight::Area, NormalWeight::Angle};
        for (std::size_t k = 0; k < weights.size(); ++k) {
            const Vec3 normal = vertexNormals(mesh, weights[k])[corner];
            failures[k] += (normal - truth.normalized()).norm() > 1e-9 ? 1 : 0;
        }
    }
    table.addRow("normals: mean", "corner of a box", failures[0], trials);
    table.addRow("normals: by area", "corner of a box", failures[1], trials);
    table.addRow("normals: by angle", "corner of a box", failures[2], trials);
    context.progress().advance();
}

}  // namespace

void chartFailures(FigureContext& context) {
    const std::vector<MeshSet> sets = meshSets();
    context.progress().expect(static_cast<std::int64_t>(sets.size()) + 2);
    CsvTable table({"method", "case", "failures", "trials"});
    for (const MeshSet& set : sets) addMeshSet(table, set, context);
    addPolygons(table, context);
    addCorners(table, context);
    table.save(context.output("failure.csv"));
    context.chart("failures/failure.gp", "failure.png");
}

}  // namespace caustic
