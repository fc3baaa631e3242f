#include <Eigen/Geometry>
#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/progress.h"
#include "figure/csv_table.h"
#include "figure/timing.h"
#include "figures.h"
#include "figures/mesh_view.h"
#include "math/frame.h"
#include "math/spawn.h"
#include "mesh/mesh_file.h"
#include "mesh/triangle_mesh.h"
#include "mesh_sets.h"

namespace caustic {

namespace {

struct RaySet {
    std::string name;
    std::vector<Ray> rays;
    bool shadow;  // whether any hit will do
};

// About the normal, by its cosine: where a diffuse surface sends light.
Vec3 diffuseDirection(const Vec3& normal, Random& random) {
    const Frame frame = Frame::around(normal);
    const Real z = std::sqrt(random.uniform());
    const Real angle = 6.283185307179586 * random.uniform();
    const Real across = std::sqrt(1 - z * z);
    return across * std::cos(angle) * frame.s + across * std::sin(angle) * frame.t + z * frame.n;
}

// Rays from the eye, from what they hit into a random direction, and from there to a lamp.
std::array<RaySet, 3> raySets(const TriangleMesh& mesh, int side, std::uint64_t seed) {
    std::array<RaySet, 3> sets = {{{"primary", {}, false}, {"diffuse bounce", {}, false}, {"shadow", {}, true}}};
    const RayView view = viewOf(mesh.bounds(), Vec3(0.25, 0.3, 1));
    const Vec3 lamp = mesh.bounds().center() + 2 * mesh.bounds().diagonal().norm() * Vec3(-0.5, 0.8, 0.6).normalized();
    for (int i = 0; i < side * side; ++i) {
        const Ray ray = rayThrough(view, Vec2((i % side + 0.5) / side, (i / side + 0.5) / side), 1);
        sets[0].rays.push_back(ray);
        const auto hit = mesh.intersect(ray);
        if (!hit) continue;
        Random random(seed, {static_cast<std::uint64_t>(i)});
        const Vec3 outside = hit->ng.dot(ray.direction) < 0 ? hit->ng : Vec3(-hit->ng);
        sets[1].rays.push_back(spawnRay(*hit, diffuseDirection(outside, random)));
        sets[2].rays.push_back(spawnRayTo(*hit, lamp));
    }
    return sets;
}

double buildMilliseconds(MeshTreeKind kind, const std::shared_ptr<const MeshData>& mesh, int trials) {
    return medianNanoseconds({[&] { keep(plantMeshTree(kind, mesh)); }}, {trials, 1e-6})[0] * 1e-6;
}

}  // namespace

void chartSpeed(FigureContext& context) {
    const auto data = std::make_shared<const MeshData>(loadMesh(context.asset("assets/meshes/bunny.ply")));
    const TriangleMesh mesh(*data);
    const auto sets = raySets(mesh, context.byQuality(64, 256), context.seed());
    context.progress().expect(static_cast<std::int64_t>(std::size(allMeshTrees)));
    CsvTable table({"method", "rays", "megarays_per_second", "build_ms", "bytes_per_triangle"});
    for (const MeshTreeKind kind : allMeshTrees) {
        const bool brute = kind == MeshTreeKind::BruteForce;
        const auto tree = plantMeshTree(kind, data);
        const double milliseconds = brute ? 0 : buildMilliseconds(kind, data, context.byQuality(1, 3));
        const double bytes = static_cast<double>(tree->size().bytes) / static_cast<double>(data->triangles.size());
        for (const RaySet& set : sets) {
            const std::size_t count = brute ? 8 : set.rays.size();
            const auto shoot = [&] {
                for (std::size_t i = 0; i < count; ++i) {
                    const Ray& ray = set.rays[i * (set.rays.size() / count)];
                    if (set.shadow) {
                        keep(tree->occluded(ray));
                    } else {
                        keep(tree->intersect(ray));
                    }
                }
            };
            const double nanoseconds = medianNanoseconds({shoot}, {context.byQuality(3, 9), 1e-2})[0];
            table.addRow(name(kind), set.name, 1e3 * static_cast<double>(count) / nanoseconds, milliseconds, bytes);
        }
        context.progress().advance();
    }
    table.save(context.output("speed.csv"));
    context.chart("measures/speed.gp", "speed.png");
}

}  // namespace caustic
