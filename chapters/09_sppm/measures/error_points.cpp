#include "measures/error_points.h"

#include <algorithm>
#include <cmath>

#include "camera/box_filter.h"
#include "core/parallel.h"
#include "core/progress.h"
#include "image/image_file.h"
#include "image/picture_error.h"
#include "integrator/render.h"
#include "measures/mirror_caustic.h"
#include "sampling/independent_sampler.h"
#include "sampling/sobol_sampler.h"

namespace caustic {

namespace {

constexpr int width = 64;
constexpr double longer = 10;  // times the photon methods' time

// Relative RMSE over the pixels whose rank by brightness, from 0 to 1, lies in a range.
Real relativeError(const Image& picture, const Image& reference, Real from, Real to) {
    std::vector<std::pair<Real, Real>> pixels;  // brightness, squared error
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
            const Real truth = reference.at(x, y).mean();
            pixels.emplace_back(truth, std::pow(picture.at(x, y).mean() - truth, 2));
        }
    }
    std::sort(pixels.begin(), pixels.end());
    const auto count = static_cast<Real>(pixels.size());
    Real squares = 0;
    Real truths = 0;
    for (auto i = static_cast<std::size_t>(from * count); i < static_cast<std::size_t>(to * count); ++i) {
        squares += pixels[i].second;
        truths += pixels[i].first * pixels[i].first;
    }
    return std::sqrt(squares / truths);
}

std::vector<ErrorPoint> measured(Method method, double seconds, const Image& reference, std::uint64_t seed) {
    const Scene scene(mirrorCaustic(width));
    const IndependentSampler random(seed);
    const SobolSampler sobol(seed);
    const Sampler& sampler = tracesPhotons(method) ? static_cast<const Sampler&>(sobol) : random;
    const BoxFilter filter;
    const auto integrator = makeIntegrator(method, scene, sampler, filter, mirrorCausticSettings());
    std::vector<ErrorPoint> points;
    const auto look = [&](const Rendering& soFar) {
        if (soFar.passes < std::int64_t{1} << points.size()) return true;
        const Image picture = developed(*integrator, soFar);
        points.push_back({method, soFar.passes, soFar.seconds, rmse(picture, reference, {}),
                          relativeError(picture, reference, 0.9, 1), relativeError(picture, reference, 0, 0.5)});
        return true;
    };
    requireFinite(render(*integrator, {.seconds = seconds, .look = look}));
    return points;
}

}  // namespace

std::vector<ErrorPoint> mirrorCausticErrors(double seconds, FigureContext& context) {
    const Image reference =
        mirrorCausticReference(loadImage(context.asset("assets/references/caustic_floor.exr")), width);
    std::vector<std::vector<ErrorPoint>> byMethod(allMethods.size());
    context.progress().expect(static_cast<std::int64_t>(allMethods.size()));
    parallelFor(static_cast<std::int64_t>(allMethods.size()), context.threads(), [&](std::int64_t i) {
        const auto at = static_cast<std::size_t>(i);
        const Method method = allMethods[at];
        byMethod[at] = measured(method, tracesPhotons(method) ? seconds : longer * seconds, reference, context.seed());
        context.progress().advance();
    });
    std::vector<ErrorPoint> all;
    for (const auto& own : byMethod) all.insert(all.end(), own.begin(), own.end());
    return all;
}

}  // namespace caustic
