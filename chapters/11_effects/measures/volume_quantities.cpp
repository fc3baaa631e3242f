#include "measures/volume_quantities.h"

#include <algorithm>
#include <cmath>

#include "accel/point_beam_tree.h"
#include "core/random.h"
#include "figure/timing.h"
#include "integrator/medium_light.h"
#include "measures/air_light.h"
#include "sampling/independent_sampler.h"
#include "scene/scene.h"

namespace caustic {

namespace {

// The largest deviation of 20,000 places from the closed form, over rays that miss the lamp by less and less.
void addAirLight(CsvTable& table, FigureContext& context) {
    const AirLight light;
    const Scene scene(light.scene(1, 1));
    const LightChoice lights(scene.lights());
    const IndependentSampler sampler(context.seed());
    Real largest = 0;
    for (const Real miss : {0.5, 0.1, 0.02, 0.004, 0.0008}) {
        const Ray ray = {light.eye, Vec3(miss, 2, 0.3 * miss).normalized()};
        std::vector<MediumSpan> spans;
        MediumStack media = scene.cameraMedia();
        Color passed;
        RayCounts counts;
        scene.follow(ray, media, passed, spans, counts);
        const Color found =
            scatteredEquiAngular(scene, lights, spans.front(), 20'000, 0, sampler.start(0, {0, 0}, 0), counts);
        largest = std::max(largest, (found / light.scatteredOnce(ray.direction) - 1).abs().maxCoeff());
    }
    table.addRow("equi-angular", "air-light: largest deviation", 100 * largest, "%", "the closed form; at most 1");
}

// The same beams by the tree and by brute force.
void addBeamTree(CsvTable& table, FigureContext& context) {
    const int count = context.byQuality(100'000, 1'000'000);
    const std::string photons = std::to_string(count) + " photons: ";
    Random random(context.seed(), {static_cast<std::uint64_t>(count)});
    const auto inCube = [&random] {
        const Real x = random.uniform(-1, 1);
        const Real y = random.uniform(-1, 1);
        return Vec3(x, y, random.uniform(-1, 1));
    };
    std::vector<Vec3> points;
    for (int i = 0; i < count; ++i) points.push_back(inCube());
    const PointBeamTree tree(points);
    std::vector<Beam> beams;
    for (int i = 0; i < 16; ++i) {
        const Vec3 from = 3 * inCube();
        beams.push_back({{from, (0.5 * inCube() - from).normalized()}, 0.01});
    }
    std::int64_t found = 0;
    const auto byTree = [&] {
        for (const Beam& beam : beams) tree.along(beam, [&](const BeamPoint&) { ++found; });
    };
    byTree();
    table.addRow("beam tree", photons + "found", static_cast<Real>(found) / 16, "photons a ray", "within 1 cm");
    std::size_t next = 0;
    const auto byBruteForce = [&] {
        const Beam& beam = beams[next++ % beams.size()];
        for (std::uint32_t i = 0; i < points.size(); ++i) found += beam.holds(beam.nearest(i, points[i]));
        keep(found);
    };
    const std::vector<double> times = medianNanoseconds({[&] {
                                                             byTree();
                                                             keep(found);
                                                         },
                                                         byBruteForce},
                                                        {.rounds = 7, .secondsPerBatch = 2e-3});
    table.addRow("beam tree", photons + "time", times[0] / 16e3, "µs a ray", "");
    table.addRow("brute force", photons + "time", times[1] / 1e3, "µs a ray", "");
    table.addRow("beam tree", photons + "faster than brute force", 16 * times[1] / times[0], "times", "at least 50");
}

}  // namespace

void addVolumeQuantities(CsvTable& table, FigureContext& context) {
    addAirLight(table, context);
    addBeamTree(table, context);
}

}  // namespace caustic
