#include <map>
#include <stdexcept>
#include <utility>

#include "camera/box_filter.h"
#include "core/parallel.h"
#include "core/progress.h"
#include "figures.h"
#include "image/drawing.h"
#include "image/tone_mapping.h"
#include "integrator/bidirectional_path_tracer.h"
#include "modeler/peers_box.h"
#include "sampling/independent_sampler.h"

namespace caustic {

namespace {

constexpr int width = 112;  // of each small picture
constexpr int gap = 8;
constexpr int top = 84;
constexpr int fewestSegments = 2;
constexpr int mostSegments = 5;

// What a strategy adds, as it is and weighted.
struct StrategyFilms {
    Film plain = Film(width, width);
    Film weighted = Film(width, width);
};

using Films = std::map<std::pair<int, int>, StrategyFilms>;

// All strategies' pictures, pass by pass, each row's contributions entered in its order.
Films strategyFilms(const Scene& scene, std::int64_t samples, FigureContext& context) {
    const IndependentSampler sampler(context.seed());
    const BoxFilter filter;
    const BidirectionalPathTracer tracer(scene, sampler, filter, {.maxLength = mostSegments});
    constexpr Real pixels = width * width;
    Films films;
    context.progress().expect(samples);
    for (std::int64_t index = 0; index < samples; ++index) {
        std::vector<std::vector<std::vector<StrategyContribution>>> rows(width);
        parallelFor(width, context.threads(), [&](std::int64_t y) {
            RayCounts counts;
            for (int x = 0; x < width; ++x)
                rows[static_cast<std::size_t>(y)].push_back(
                    tracer.contributions({{x, static_cast<int>(y)}, index}, counts));
        });
        for (int y = 0; y < width; ++y) {
            for (int x = 0; x < width; ++x) {
                for (const auto& one : rows[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)]) {
                    StrategyFilms& own = films[{one.s, one.t}];
                    // What belongs to the path's own pixel counts as often as there are pixels.
                    const Vec2 place = one.t == 1 ? one.film : Vec2(x + 0.5, y + 0.5);
                    const Color value = one.t == 1 ? one.value : one.value * pixels;
                    own.plain.splat(place, value, filter);
                    own.weighted.splat(place, one.weight * value, filter);
                }
            }
        }
        context.progress().advance();
    }
    for (auto& [strategy, own] : films) {
        own.plain.countSplatPaths(samples * width * width);
        own.weighted.countSplatPaths(samples * width * width);
    }
    return films;
}

}  // namespace

void drawPyramid(FigureContext& context) {
    const std::int64_t samples = context.byQuality(2, 32);
    const Scene scene(peersBox(width, width));
    const Films films = strategyFilms(scene, samples, context);
    const int half = (mostSegments + 1) * (width + gap);
    Drawing drawing(2 * half + 5 * gap, top + (mostSegments - fewestSegments + 1) * (width + 30));
    const TextStyle title = {.size = 20, .horizontal = HorizontalAnchor::Centre};
    const TextStyle caption = {.size = 14, .horizontal = HorizontalAnchor::Centre};
    drawing.text({gap + half / 2.0, 30}, "each strategy by itself", title);
    drawing.text({half + 4.0 * gap + half / 2.0, 30}, "weighted: these add up to the picture", title);
    for (const auto& [strategy, own] : films) {
        const auto [s, t] = strategy;
        if (own.plain.badSamples() > 0) throw std::runtime_error("a strategy's contribution is not finite");
        const int segments = s + t - 1;
        if (segments < fewestSegments || segments > mostSegments) continue;
        const Real y = top + (segments - fewestSegments) * (width + 30);
        const Real x = gap + (mostSegments - segments) * (width + gap) / 2.0 + s * (width + gap);
        for (const bool weighted : {false, true}) {
            const Real left = x + (weighted ? half + 3 * gap : 0);
            const Image picture = toneMapped((weighted ? own.weighted : own.plain).image(), 2, 4);
            drawing.text({left + width / 2.0, y - 8}, std::to_string(s) + ", " + std::to_string(t), caption);
            drawing.image(picture, {Vec2(left, y), Vec2(left + width, y + width)});
        }
    }
    drawing.save(context.output("pyramid.png"));
}

}  // namespace caustic
