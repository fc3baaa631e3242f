#include "core/progress.h"
#include "figures.h"
#include "image/drawing.h"
#include "sampling/sampler_names.h"

namespace caustic {

namespace {

constexpr int side = 330;
constexpr int gap = 18;
constexpr int top = 46;

// The first points of a pixel, of two pairs of dimensions: film, and direction at the first vertex.
void drawPoints(Drawing& drawing, const Sampler& sampler, std::int64_t count, Dimension dimension, const Vec2& corner) {
    drawing.rectangle(Bounds2(corner, corner + Vec2(side, side)), Stroke{palette::grid, 1});
    for (std::int64_t i = 0; i < count; ++i)
        drawing.circle(corner + side * sampler.start(0, {3, 5}, i).pair(dimension), 2.6, palette::blue);
}

}  // namespace

void drawSamplers(FigureContext& context) {
    constexpr std::int64_t count = 256;
    const std::vector<std::string>& names = samplerNames();
    const auto columns = static_cast<int>(names.size());
    Drawing drawing(gap + columns * (side + gap), 2 * (top + side) + gap);
    context.progress().expect(columns);
    for (int i = 0; i < columns; ++i) {
        const auto sampler = makeSampler(names[static_cast<std::size_t>(i)], context.seed(), count);
        const Real left = gap + i * (side + gap);
        const auto row = [&](const std::string& what, Dimension dimension, Real upper) {
            drawing.text({left + side / 2.0, upper - 14}, names[static_cast<std::size_t>(i)] + ": " + what,
                         {.size = 18, .horizontal = HorizontalAnchor::Centre});
            drawPoints(drawing, *sampler, count, dimension, {left, upper});
        };
        row("on the film", Dimension::film(), top);
        row("direction", Dimension::vertex(0, VertexUse::Direction), 2 * top + side);
        context.progress().advance();
    }
    drawing.save(context.output("samplers.png"));
}

}  // namespace caustic
