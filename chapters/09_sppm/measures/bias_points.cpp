#include "measures/bias_points.h"

#include <cmath>

#include "core/parallel.h"
#include "core/progress.h"
#include "measures/spot_under_mirror.h"

namespace caustic {

namespace {

constexpr Real startRadius = 0.2;
constexpr Real fixedRadius = 1 - 1e-6;

Real slopeOf(const BiasCurve& curve) {
    const std::size_t first = curve.passes.size() / 2;
    Real n = 0;
    Vec2 mean = Vec2::Zero();
    const auto place = [&](std::size_t i) {
        return Vec2(std::log(static_cast<Real>(curve.passes[i])), std::log(std::abs(curve.bias[i])));
    };
    for (std::size_t i = first; i < curve.passes.size(); ++i, ++n) mean += place(i);
    mean /= n;
    Real xy = 0;
    Real xx = 0;
    for (std::size_t i = first; i < curve.passes.size(); ++i) {
        const Vec2 off = place(i) - mean;
        xy += off.x() * off.y();
        xx += off.x() * off.x();
    }
    return xy / xx;
}

void follow(BiasCurve& curve, RadiusRule rule, std::int64_t passes, std::uint64_t seed) {
    const SpotUnderMirror spot;
    SppmSettings settings;
    settings.rule = rule;
    settings.alpha = curve.alpha < 1 ? curve.alpha : fixedRadius;
    settings.radius = startRadius;
    settings.photons = 4000;
    spot.found(settings, passes, seed, [&](std::int64_t done, Real radiance) {
        if (done < std::int64_t{1} << curve.passes.size()) return;
        curve.passes.push_back(done);
        curve.bias.push_back(1 - radiance / spot.truth());
    });
    curve.slope = slopeOf(curve);
    curve.firstExpected = spot.biasWithin(startRadius);
}

}  // namespace

std::vector<BiasCurve> biasCurves(FigureContext& context) {
    std::vector<BiasCurve> curves = {{"SPPM by pass ①", 1.0 / 3, {}, {}},
                                     {"SPPM by pass ①", 2.0 / 3, {}, {}},
                                     {"SPPM by pass ①", 0.9, {}, {}},
                                     {"SPPM by point ②", 2.0 / 3, {}, {}},
                                     {"photon mapping", 1, {}, {}}};
    const std::int64_t passes = context.byQuality(64, 2048);
    context.progress().expect(static_cast<std::int64_t>(curves.size()));
    parallelFor(static_cast<std::int64_t>(curves.size()), context.threads(), [&](std::int64_t i) {
        const auto at = static_cast<std::size_t>(i);
        follow(curves[at], at == 3 ? RadiusRule::Point : RadiusRule::Pass, passes, context.seed() + at);
        context.progress().advance();
    });
    return curves;
}

}  // namespace caustic
