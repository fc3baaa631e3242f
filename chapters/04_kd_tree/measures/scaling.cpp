#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "core/progress.h"
#include "figure/csv_table.h"
#include "figures.h"
#include "mesh/mesh_tree.h"
#include "mesh_sets.h"

namespace caustic {

namespace {

// y = offset + slope x by least squares, and the share of y's variance that it explains.
struct Line {
    double slope = 0;
    double offset = 0;
    double explained = 0;
};

Line fitted(const std::vector<double>& x, const std::vector<double>& y) {
    const auto n = static_cast<double>(x.size());
    double sx = 0, sy = 0, sxx = 0, sxy = 0, syy = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        sx += x[i];
        sy += y[i];
        sxx += x[i] * x[i];
        sxy += x[i] * y[i];
        syy += y[i] * y[i];
    }
    Line line;
    line.slope = (n * sxy - sx * sy) / (n * sxx - sx * sx);
    line.offset = (sy - line.slope * sx) / n;
    const double correlation = n * sxy - sx * sy;
    line.explained = correlation * correlation / ((n * sxx - sx * sx) * (n * syy - sy * sy));
    return line;
}

struct Series {
    std::vector<double> logSize;  // log2 of the number of triangles
    std::vector<double> nodes;    // a ray
    std::vector<double> work;     // of the builder
};

void addFits(CsvTable& table, const std::string& method, const Series& series) {
    const Line visits = fitted(series.logSize, series.nodes);
    table.addRow(method, "nodes a ray: more for twice the triangles", visits.slope, "nodes",
                 "constant if they grow like log n");
    table.addRow(method, "nodes a ray: variance that a line in log n explains", visits.explained, "share", "1");
    if (series.work.front() == 0) return;
    std::vector<double> logWork;
    std::vector<double> logExpected;
    for (std::size_t i = 0; i < series.work.size(); ++i) {
        logWork.push_back(std::log(series.work[i]));
        logExpected.push_back(series.logSize[i] * std::log(2.0) + std::log(series.logSize[i]));
    }
    const Line build = fitted(logExpected, logWork);
    table.addRow(method, "build: exponent of n log n", build.slope, "", "1 if events grow like n log n");
    table.addRow(method, "build: variance that n log n explains", build.explained, "share", "1");
}

}  // namespace

void chartScaling(FigureContext& context) {
    const std::vector<double> exponents = context.quality() == Quality::Draft
                                              ? std::vector<double>{2, 2.5, 3, 3.5, 4}
                                              : std::vector<double>{2, 2.5, 3, 3.5, 4, 4.5, 5, 5.5, 6};
    constexpr std::array kinds = {MeshTreeKind::MedianKdTree, MeshTreeKind::SahKdTree, MeshTreeKind::WideKdTree,
                                  MeshTreeKind::WideBvh};
    constexpr int rays = 20'000;
    std::array<Series, kinds.size()> all;
    CsvTable table({"method", "triangles", "nodes_per_ray", "tests_per_ray", "depth", "build_events"});
    context.progress().expect(static_cast<std::int64_t>(exponents.size()));
    for (const double exponent : exponents) {
        const auto mesh = std::make_shared<const MeshData>(
            bumpySphere(static_cast<std::uint32_t>(std::lround(std::pow(10, exponent)))));
        const auto triangles = static_cast<double>(mesh->triangles.size());
        const Bounds3 box = boundsOf(*mesh);
        for (std::size_t i = 0; i < kinds.size(); ++i) {
            const auto tree = plantMeshTree(kinds[i], mesh);
            MeshWork work;
            for (int ray = 0; ray < rays; ++ray) {
                Random random(context.seed(), {static_cast<std::uint64_t>(ray)});
                tree->intersectCounted(randomChord(box, random), work);
            }
            const MeshTreeSize size = tree->size();
            const double nodes = static_cast<double>(work.nodes) / rays;
            table.addRow(name(kinds[i]), mesh->triangles.size(), nodes, static_cast<double>(work.tests) / rays,
                         size.depth, size.buildWork);
            all[i].logSize.push_back(std::log2(triangles));
            all[i].nodes.push_back(nodes);
            all[i].work.push_back(static_cast<double>(size.buildWork));
        }
        context.progress().advance();
    }
    table.save(context.output("scaling.csv"));
    CsvTable fits({"method", "case", "value", "unit", "reference"});
    for (std::size_t i = 0; i < kinds.size(); ++i) addFits(fits, name(kinds[i]), all[i]);
    fits.save(context.output("quantity.csv"));
    context.chart("measures/scaling.gp", "scaling.png");
}

}  // namespace caustic
