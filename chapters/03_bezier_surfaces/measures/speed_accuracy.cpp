#include <cmath>
#include <functional>
#include <memory>
#include <string>

#include "core/parallel.h"
#include "core/progress.h"
#include "figure/csv_table.h"
#include "figure/timing.h"
#include "figures.h"
#include "measures/triangle_tree.h"
#include "revolution_cases.h"
#include "revolution_reference.h"
#include "surface/newton_revolution.h"
#include "surface/tessellation.h"

namespace caustic {

namespace {

constexpr std::size_t raysPerTiming = 4000;

using Nearest = std::function<std::optional<Real>(const Ray&, Random&)>;

struct Method {
    std::string name;
    std::string setting;
    Nearest nearest;
};

std::vector<Method> methods(const SurfaceOfRevolution& surface) {
    std::vector<Method> all;
    const auto addNewton = [&](const std::string& name, const std::string& setting, NewtonStartRule rule, int samples) {
        const auto newton = std::make_shared<NewtonRevolution>(surface.profile(), rule, samples);
        all.push_back(
            {name, setting, [newton](const Ray& ray, Random& random) { return newton->intersect(ray, random); }});
    };
    for (const int starts : {1, 2, 4, 8, 16}) {
        addNewton("random starts", "starts=" + std::to_string(starts), NewtonStartRule::Random, starts);
    }
    addNewton("4x4 starts", "starts=16", NewtonStartRule::Grid, 1);
    for (const int samples : {1, 2, 4, 8, 16, 32}) {
        addNewton("bracketing starts", "samples=" + std::to_string(samples), NewtonStartRule::Bracketing, samples);
    }
    for (const double tolerance : {3e-2, 1e-2, 3e-3, 1e-3, 3e-4, 1e-4}) {
        const auto tree = std::make_shared<TriangleTree>(tessellated(surface, tolerance));
        all.push_back({"triangles", "tolerance=" + formatReal(tolerance) + ";triangles=" + std::to_string(tree->size()),
                       [tree](const Ray& ray, Random&) { return tree->intersect(ray); }});
    }
    all.push_back({"robust", "depth=27", [&surface](const Ray& ray, Random&) -> std::optional<Real> {
                       const auto hit = surface.intersect(ray);
                       return hit ? std::optional<Real>(hit->t) : std::nullopt;
                   }});
    return all;
}

Ray rayOf(const SurfaceOfRevolution& surface, std::uint64_t i, std::uint64_t seed) {
    Random random(seed, {i});
    return revolutionRaySets()[0].make(surface, random);
}

// For each method, the rays whose nearest meeting it loses, invents or displaces by more than a thousandth of the size.
std::vector<std::int64_t> countWrong(const SurfaceOfRevolution& surface, const std::vector<Method>& all,
                                     std::int64_t rays, FigureContext& context) {
    constexpr std::int64_t perBatch = 1000;
    const std::int64_t batches = rays / perBatch;
    std::vector<std::vector<std::int64_t>> wrong(static_cast<std::size_t>(batches),
                                                 std::vector<std::int64_t>(all.size()));
    parallelFor(batches, context.threads(), [&](std::int64_t batch) {
        for (std::int64_t i = 0; i < perBatch; ++i) {
            const auto number = static_cast<std::uint64_t>(batch * perBatch + i);
            const Ray ray = rayOf(surface, number, context.seed());
            const auto reference = meetingsBySubdivision(surface.profile(), ray);
            if (!reference.empty() && reference.front().inBand) continue;
            const Real slack = 1e-3 * surface.bounds().diagonal().norm() / ray.direction.norm();
            for (std::size_t m = 0; m < all.size(); ++m) {
                Random random(context.seed(), {number, m});
                const auto t = all[m].nearest(ray, random);
                const bool right =
                    t.has_value() != reference.empty() &&
                    (!t || (*t >= reference.front().tLow - slack && *t <= reference.front().tHigh + slack));
                wrong[static_cast<std::size_t>(batch)][m] += right ? 0 : 1;
            }
        }
        context.progress().advance();
    });
    std::vector<std::int64_t> sum(all.size());
    for (const auto& counts : wrong) {
        for (std::size_t m = 0; m < all.size(); ++m) sum[m] += counts[m];
    }
    return sum;
}

}  // namespace

void chartSpeedAccuracy(FigureContext& context) {
    const SurfaceOfRevolution surface(plainVase());
    const std::vector<Method> all = methods(surface);
    const std::int64_t rays = context.byQuality<std::int64_t>(20'000, 1'000'000);
    context.progress().expect(rays / 1000 + 1);
    const auto wrong = countWrong(surface, all, rays, context);

    std::vector<Ray> batch;
    for (std::size_t i = 0; i < raysPerTiming; ++i) batch.push_back(rayOf(surface, i, context.seed()));
    std::vector<std::function<void()>> pieces;
    for (const Method& method : all) {
        pieces.emplace_back([&batch, &method, seed = context.seed()] {
            Random random(seed, {});
            Real sum = 0;
            for (const Ray& ray : batch) sum += method.nearest(ray, random).value_or(0);
            keep(sum);
        });
    }
    const auto nanoseconds = medianNanoseconds(pieces, {context.byQuality(5, 21), context.byQuality(5e-4, 2e-3)});
    CsvTable table({"method", "setting", "time", "time_unit", "error", "error_unit"});
    for (std::size_t m = 0; m < all.size(); ++m) {
        table.addRow(all[m].name, all[m].setting, nanoseconds[m] / static_cast<double>(raysPerTiming), "ns per ray",
                     1e6 * static_cast<double>(wrong[m]) / static_cast<double>(rays), "wrong rays per million");
    }
    table.save(context.output("speed_accuracy.csv"));
    context.chart("measures/speed_accuracy.gp", "speed_accuracy.png");
}

}  // namespace caustic
