#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "camera/box_filter.h"
#include "core/progress.h"
#include "core/random.h"
#include "figure/csv_table.h"
#include "figure/timing.h"
#include "figures.h"
#include "integrator/ray_tracer.h"
#include "measures/grid_sampler.h"
#include "sampling/independent_sampler.h"
#include "sampling/stratified_sampler.h"
#include "slab.h"
#include "soft_shadow.h"

namespace caustic {

namespace {

// What is measured: an error now, and the same work again for the clock.
struct Measurement {
    std::string method;
    std::string setting;
    Real error;
    std::string unit;
    std::int64_t rays;  // that a piece of work follows
    std::function<void()> work;
};

// Radiance of the floor at a point of each of side × side cells over [−2, 2]², each with a pixel of its own. The points
// are strewn: in step with the samples' grid, every one of them would see the shadow's edge at the same place between
// two rows of the lamp, and the grid would look far better or worse than it is.
class ShadowMeasure {
public:
    ShadowMeasure(std::uint64_t seed, int side) : scene_(softShadowScene()), side_(side) {
        for (int cell = 0; cell < cells(); ++cell) {
            Random random(seed, {static_cast<std::uint64_t>(cell)});
            const Real x = (cell % side + random.uniform()) / side;
            const Real z = (cell / side + random.uniform()) / side;
            places_.emplace_back(4 * x - 2, 4 * z - 2);
        }
    }

    Real radiance(const Sampler& sampler, int samples, int cell) const {
        const RayTracer tracer(scene_, sampler, filter_, {.maxDepth = 0, .leastWeight = 0, .shadowSamples = samples});
        const Vec2& at = place(cell);
        RayCounts counts;
        const Ray ray = {Vec3(at.x(), 0.5, at.y()), -Vec3::UnitY()};
        return tracer.Li(ray, {}, sampler.start(0, {cell % side_, cell / side_}, 0), counts).x();
    }

    // Root mean square over the grid.
    Real error(const Sampler& sampler, int samples) const {
        Real squares = 0;
        for (int cell = 0; cell < cells(); ++cell) {
            const Vec2& at = place(cell);
            const Real off = radiance(sampler, samples, cell) - softShadow(at.x(), at.y());
            squares += off * off;
        }
        return std::sqrt(squares / cells());
    }

    int cells() const { return side_ * side_; }

private:
    const Vec2& place(int cell) const { return places_[static_cast<std::size_t>(cell)]; }

    Scene scene_;
    BoxFilter filter_;
    int side_;
    std::vector<Vec2> places_;
};

void addShadows(std::vector<Measurement>& all, const std::shared_ptr<ShadowMeasure>& measure, FigureContext& context) {
    for (const int perAxis : {1, 2, 4, 8, 16}) {
        const std::shared_ptr<const Sampler> samplers[] = {std::make_shared<IndependentSampler>(context.seed()),
                                                           std::make_shared<StratifiedSampler>(context.seed(), perAxis),
                                                           std::make_shared<GridSampler>(perAxis)};
        const std::string names[] = {"independent shadow samples", "stratified shadow samples",
                                     "regular grid of shadow samples"};
        for (std::size_t i = 0; i < 3; ++i) {
            const int samples = perAxis * perAxis;
            const auto sampler = samplers[i];
            all.push_back({names[i], "samples=" + std::to_string(samples), measure->error(*sampler, samples),
                           "radiance (rms)", measure->cells(), [measure, sampler, samples] {
                               Real sum = 0;
                               for (int cell = 0; cell < measure->cells(); ++cell)
                                   sum += measure->radiance(*sampler, samples, cell);
                               keep(sum);
                           }});
            context.progress().advance();
        }
    }
}

// Panes of many reflectances and absorptions.
struct Panes {
    std::vector<std::unique_ptr<Scene>> scenes;
    std::vector<Real> truth;
};

Panes somePanes(std::uint64_t seed) {
    Panes panes;
    for (std::uint64_t i = 0; i < 64; ++i) {
        Random random(seed, {i});
        const Real reflectance = random.uniform(0.1, 0.9);
        const Real sigma = random.uniform(0, 0.5);
        panes.scenes.push_back(std::make_unique<Scene>(slabScene(reflectance, sigma)));
        panes.truth.push_back(slabTransmission(reflectance, sigma));
    }
    return panes;
}

Real throughPane(const Scene& scene, const RayTracerSettings& settings) {
    const IndependentSampler sampler(1);
    const BoxFilter filter;
    const RayTracer tracer(scene, sampler, filter, settings);
    RayCounts counts;
    return tracer.Li({Vec3(-1, 0, 0), Vec3::UnitX()}, {}, sampler.start(0, {0, 0}, 0), counts).x();
}

void addDepth(std::vector<Measurement>& all, const std::shared_ptr<Panes>& panes, const std::string& method,
              const std::string& setting, const RayTracerSettings& settings, FigureContext& context) {
    Real squares = 0;
    for (std::size_t i = 0; i < panes->scenes.size(); ++i) {
        const Real off = throughPane(*panes->scenes[i], settings) - panes->truth[i];
        squares += off * off;
    }
    const Real count = static_cast<Real>(panes->scenes.size());
    all.push_back({method, setting, std::sqrt(squares / count), "radiance (rms)",
                   static_cast<std::int64_t>(panes->scenes.size()), [panes, settings] {
                       Real sum = 0;
                       for (const auto& scene : panes->scenes) sum += throughPane(*scene, settings);
                       keep(sum);
                   }});
    context.progress().advance();
}

}  // namespace

void chartSpeedAccuracy(FigureContext& context) {
    context.progress().expect(15 + 12 + 1);
    std::vector<Measurement> all;
    addShadows(all, std::make_shared<ShadowMeasure>(context.seed(), 32), context);
    const auto panes = std::make_shared<Panes>(somePanes(context.seed()));
    for (const int depth : {1, 2, 4, 8, 16, 32})
        addDepth(all, panes, "fixed depth", "depth=" + std::to_string(depth), {.maxDepth = depth}, context);
    for (const int digits : {1, 2, 3, 4, 5, 6})
        addDepth(all, panes, "least weight", "weight=1e-" + std::to_string(digits),
                 {.maxDepth = 1000, .leastWeight = std::pow(10.0, -digits)}, context);

    std::vector<std::function<void()>> pieces;
    for (const Measurement& one : all) pieces.push_back(one.work);
    const auto nanoseconds = medianNanoseconds(pieces, {context.byQuality(3, 7), 1e-3});
    CsvTable table({"method", "setting", "time", "time_unit", "error", "error_unit"});
    for (std::size_t i = 0; i < all.size(); ++i) {
        table.addRow(all[i].method, all[i].setting, nanoseconds[i] / (1000 * static_cast<double>(all[i].rays)),
                     "us per eye ray", all[i].error, all[i].unit);
    }
    table.save(context.output("speed_accuracy.csv"));
    context.chart("measures/speed_accuracy.gp", "speed_accuracy.png");
}

}  // namespace caustic
