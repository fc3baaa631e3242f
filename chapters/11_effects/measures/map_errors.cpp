#include "measures/map_errors.h"

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "figure/timing.h"
#include "light/environment_map.h"
#include "maps.h"
#include "measures/lens_estimates.h"
#include "measures/sky_estimates.h"

namespace caustic {

namespace {

constexpr int mapHeight = 64;

struct Estimator {
    std::string method;
    std::string setting;
    std::string unit;
    Real truth;
    std::function<Real(Random&)> estimate;
};

std::vector<Estimator> skyEstimators(const std::shared_ptr<const Light>& map) {
    const Vec3 normal = Vec3(-0.2, 0.1, 1).normalized();
    const Real truth = referenceIrradiance(*map, normal, mapHeight);
    std::vector<Estimator> all;
    for (const SkyChoice choice : {SkyChoice::Even, SkyChoice::Cosine, SkyChoice::Brightness, SkyChoice::Both}) {
        for (const int samples : {4, 16, 64, 256, 1024}) {
            all.push_back({nameOf(choice), "samples=" + std::to_string(samples), "share of the irradiance (rms)", truth,
                           [=](Random& random) { return irradiance(*map, normal, choice, samples, random); }});
        }
    }
    return all;
}

std::vector<Estimator> lensEstimators() {
    std::vector<Estimator> all;
    for (const bool stratified : {false, true}) {
        for (const int side : {2, 4, 8, 16, 32}) {
            all.push_back({stratified ? "lens: stratified points" : "lens: random points",
                           "points=" + std::to_string(side * side), "share of the circle of confusion (rms)",
                           measuringCamera().circleOfConfusion(7), [=, camera = measuringCamera()](Random& random) {
                               return measuredBlur(camera, 7, side, stratified, random);
                           }});
        }
    }
    return all;
}

}  // namespace

void addMapErrors(CsvTable& table, FigureContext& context) {
    const std::shared_ptr<const Light> map = environmentLight(sunnySky(mapHeight));
    std::vector<Estimator> all = skyEstimators(map);
    for (Estimator& one : lensEstimators()) all.push_back(std::move(one));
    std::vector<Real> errors;
    std::vector<std::function<void()>> pieces;
    const int rounds = context.byQuality(200, 2000);
    for (const Estimator& one : all) {
        Real squares = 0;
        for (int round = 0; round < rounds; ++round) {
            Random random(context.seed(), {static_cast<std::uint64_t>(round)});
            const Real off = one.estimate(random) / one.truth - 1;
            squares += off * off;
        }
        errors.push_back(std::sqrt(squares / rounds));
        pieces.push_back([&one] {
            Random random(1, {1});
            keep(one.estimate(random));
        });
    }
    const auto nanoseconds = medianNanoseconds(pieces, {context.byQuality(5, 15), 1e-3});
    for (std::size_t i = 0; i < all.size(); ++i)
        table.addRow(all[i].method, all[i].setting, nanoseconds[i] / 1000, "us", errors[i], all[i].unit);
}

}  // namespace caustic
