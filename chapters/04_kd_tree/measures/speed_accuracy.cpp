#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "core/progress.h"
#include "core/random.h"
#include "figure/csv_table.h"
#include "figure/timing.h"
#include "figures.h"
#include "mesh/triangle_mesh.h"
#include "mesh/vertex_normals.h"

#include <Eigen/Geometry>

namespace caustic {

namespace {

constexpr Real tubeRadius = 0.4;

// A torus, which has a normal in closed form everywhere: u around the axis, v around the tube.
struct TorusPoint {
    Vec3 point;
    Vec3 normal;
};

TorusPoint torus(Real u, Real v) {
    const Vec3 outwards(std::cos(u), 0, std::sin(u));
    const Vec3 normal = std::cos(v) * outwards + std::sin(v) * Vec3::UnitY();
    return {outwards + tubeRadius * normal, normal};
}

// A mesh of it, with the parameters of each vertex as uvs.
struct TorusMesh {
    MeshData mesh;
    std::vector<Vec2> parameters;
};

// A grid whose inner vertices are moved along the surface by up to 0.15 cells (a sixth could turn a triangle over), as
// scans and modellers leave them. Diagonals go one way or the other at random. The seam is closed.
TorusMesh torusMesh(std::uint32_t rows, std::uint64_t seed) {
    const std::uint32_t columns = 2 * rows;
    TorusMesh torusOf;
    for (std::uint32_t row = 0; row < rows; ++row) {
        for (std::uint32_t column = 0; column < columns; ++column) {
            Random random(seed, {rows, row, column});
            const Real u = 2 * std::numbers::pi * (column + random.uniform(-0.15, 0.15)) / columns;
            const Real v = 2 * std::numbers::pi * (row + random.uniform(-0.15, 0.15)) / rows;
            torusOf.parameters.emplace_back(u, v);
            torusOf.mesh.positions.push_back(torus(u, v).point);
        }
    }
    const auto vertex = [&](std::uint32_t row, std::uint32_t column) {
        return row % rows * columns + column % columns;
    };
    for (std::uint32_t row = 0; row < rows; ++row) {
        for (std::uint32_t column = 0; column < columns; ++column) {
            const std::uint32_t a = vertex(row, column);
            const std::uint32_t b = vertex(row, column + 1);
            const std::uint32_t c = vertex(row + 1, column + 1);
            const std::uint32_t d = vertex(row + 1, column);
            if (Random(seed, {rows, row, column, 1}).below(2) == 0) {
                torusOf.mesh.triangles.insert(torusOf.mesh.triangles.end(), {{a, c, b}, {a, d, c}});
            } else {
                torusOf.mesh.triangles.insert(torusOf.mesh.triangles.end(), {{a, d, b}, {b, d, c}});
            }
        }
    }
    return torusOf;
}

// The parameters of a corner, brought next to those of the triangle's first one across the seam.
Vec2 unwrapped(const Vec2& parameters, const Vec2& first) {
    constexpr Real turn = 2 * std::numbers::pi;
    return parameters - turn * ((parameters - first) / turn).array().round().matrix();
}

// Root mean square of the angle between shading normal and surface normal, in degrees, at a random point of each
// triangle.
Real errorOf(const TorusMesh& torusOf, const MeshData& shaded, std::uint64_t seed) {
    Real sum = 0;
    for (std::uint32_t triangle = 0; triangle < shaded.triangles.size(); ++triangle) {
        Random random(seed, {shaded.triangles.size(), triangle, 2});
        const Real size = std::sqrt(random.uniform());
        const Real share = random.uniform();
        const MeshHit at = {{0, size * (1 - share), size * share}, triangle};
        const auto& [a, b, c] = shaded.triangles[triangle];
        const Vec2 pa = torusOf.parameters[a];
        const Vec2 pb = unwrapped(torusOf.parameters[b], pa);
        const Vec2 pc = unwrapped(torusOf.parameters[c], pa);
        const Vec2 place = (1 - at.b1 - at.b2) * pa + at.b1 * pb + at.b2 * pc;
        const Vec3 truth = torus(place.x(), place.y()).normal;
        const Vec3 ns = interpolatedNormal(shaded, at, twiceArea(shaded, triangle).normalized());
        const Real angle = std::atan2(ns.cross(truth).norm(), ns.dot(truth));
        sum += angle * angle;
    }
    return std::sqrt(sum / static_cast<Real>(shaded.triangles.size())) * 180 / std::numbers::pi;
}

struct Weighting {
    std::string name;
    NormalWeight weight;
};

}  // namespace

void chartSpeedAccuracy(FigureContext& context) {
    const std::array<Weighting, 3> weightings = {
        {{"mean", NormalWeight::Mean}, {"area", NormalWeight::Area}, {"angle", NormalWeight::Angle}}};
    constexpr std::array<std::uint32_t, 7> rows = {8, 12, 16, 24, 32, 48, 64};
    context.progress().expect(static_cast<std::int64_t>(rows.size()) + 1);
    struct Point {
        std::string method;
        std::size_t triangles;
        Real error;
    };
    std::vector<Point> points;
    std::vector<std::function<void()>> pieces;
    for (const std::uint32_t row : rows) {
        const TorusMesh torusOf = torusMesh(row, context.seed());
        points.push_back({"flat", torusOf.mesh.triangles.size(), errorOf(torusOf, torusOf.mesh, context.seed())});
        pieces.push_back([mesh = torusOf.mesh] {
            for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) keep(twiceArea(mesh, i).normalized());
        });
        for (const Weighting& weighting : weightings) {
            const MeshData shaded = withVertexNormals(torusOf.mesh, weighting.weight);
            points.push_back({weighting.name, shaded.triangles.size(), errorOf(torusOf, shaded, context.seed())});
            pieces.push_back([mesh = torusOf.mesh, weight = weighting.weight] { keep(vertexNormals(mesh, weight)); });
        }
        context.progress().advance();
    }
    const auto nanoseconds = medianNanoseconds(pieces, {context.byQuality(5, 15), context.byQuality(5e-4, 2e-3)});
    CsvTable table({"method", "setting", "time", "time_unit", "error", "error_unit"});
    for (std::size_t i = 0; i < points.size(); ++i) {
        table.addRow(points[i].method, "triangles=" + std::to_string(points[i].triangles), nanoseconds[i] / 1e3,
                     "us per mesh", points[i].error, "degrees (rms)");
    }
    table.save(context.output("speed_accuracy.csv"));
    context.chart("measures/speed_accuracy.gp", "speed_accuracy.png");
}

}  // namespace caustic
