#include <array>
#include <functional>
#include <string>
#include <vector>

#include "core/progress.h"
#include "core/text.h"
#include "failures/closed_mesh.h"
#include "failures/leaks.h"
#include "figure/csv_table.h"
#include "figure/timing.h"
#include "figures.h"

namespace caustic {

namespace {

constexpr std::array<double, 6> distances = {0.1, 1, 10, 100, 1e3, 1e4};
constexpr std::size_t raysPerBatch = 64;

// A mesh and rays from inside it: one triangle in eighty is hit, or a few more, as in the leaf of a tree.
std::function<void()> batchOf(const TriangleMethod& method, double away, std::uint64_t seed) {
    Random random(seed, {0});
    const ClosedMesh mesh = randomClosedMesh(random, away);
    std::vector<Vec3> corners;
    for (int i = 0; i < static_cast<int>(mesh.triangles.size()); ++i) {
        for (const Vec3& corner : mesh.corners(i)) corners.push_back(corner);
    }
    std::vector<Ray> rays;
    for (std::size_t i = 0; i < raysPerBatch; ++i) rays.push_back({mesh.pointInside(random), randomDirection(random)});
    return [countHits = method.countHits, rays, corners] { keep(countHits(rays, corners)); };
}

}  // namespace

void chartTriangles(FigureContext& context) {
    const std::int64_t rays = context.byQuality(200'000, 1'000'000);
    const std::vector<TriangleMethod> methods = triangleMethods();
    context.progress().expect(static_cast<std::int64_t>(2 * methods.size() * distances.size()) + 1);
    std::vector<std::function<void()>> pieces;
    for (const TriangleMethod& method : methods) {
        for (const double away : distances) pieces.push_back(batchOf(method, away, context.seed()));
    }
    const auto nanoseconds = medianNanoseconds(pieces, {context.byQuality(7, 31), context.byQuality(5e-4, 2e-3)});

    CsvTable table({"method", "setting", "time", "time_unit", "error", "error_unit"});
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const TriangleMethod& method = methods[i / distances.size()];
        const double away = distances[i % distances.size()];
        for (const Aim aim : {Aim::Edges, Aim::Vertices}) {
            const FailureCount count = countLeaks(method, aim, rays, context.seed(), context.threads(), away);
            const std::string at = aim == Aim::Edges ? "edges" : "vertices";
            table.addRow(method.name, "aim=" + at + ";away=" + formatReal(away),
                         nanoseconds[i] / static_cast<double>(80 * raysPerBatch), "ns per test",
                         1e6 * static_cast<double>(count.failures) / static_cast<double>(count.trials),
                         "leaks per million rays");
            context.progress().advance();
        }
    }
    table.save(context.output("triangle.csv"));
    context.chart("measures/triangle.gp", "triangle.png");
}

}  // namespace caustic
