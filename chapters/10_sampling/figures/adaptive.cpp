#include "core/progress.h"
#include "figures.h"
#include "figures/heat.h"
#include "image/drawing.h"
#include "image/tone_mapping.h"
#include "sampling/sobol_sampler.h"
#include "work.h"

namespace caustic {

namespace {

constexpr int gap = 12;
constexpr int top = 44;
constexpr int foot = 56;
constexpr std::int64_t few = 16;  // paths a pixel: chapter 05's picture has so many

// A few paths, more of them, as many adaptive ones as take the same time, and where the paths of the latter went.
void drawStudy(const std::string& name, int shownWidth, const ChapterInputs& chapter, FigureContext& context) {
    const Study& what = study(name);
    const PictureWork work = pictureWork(name, context.quality());
    const Scene scene = what.scene(assetOf(what, context), work.width);
    const SobolSampler sampler(context.seed());
    const int shownHeight = static_cast<int>(what.aspect * shownWidth);
    Drawing drawing(gap + 4 * (shownWidth + gap), top + shownHeight + foot);
    const auto show = [&](int column, const std::string& caption, const Image& image) {
        const Vec2 corner(gap + column * (shownWidth + gap), top);
        drawing.text(corner + Vec2(shownWidth / 2.0, -14), caption,
                     {.size = 19, .horizontal = HorizontalAnchor::Centre});
        drawing.image(image, {corner, corner + Vec2(shownWidth, shownHeight)});
    };
    context.progress().expect(2 * progressSteps);

    const std::int64_t passes = uniformPasses(name, chapter, context.quality());
    int column = 0;
    for (const std::int64_t each : {few, passes}) {
        const auto uniform = what.method(scene, sampler);
        show(column++, "uniform: " + std::to_string(each) + " a pixel",
             takePicture(*uniform, each, what.tone, context));
    }
    context.progress().advance(progressSteps);

    const auto inner = what.method(scene, sampler);
    const IntervalRule rule(work.tolerance);
    AdaptiveIntegrator adaptive(*inner, sampler, rule, work.settings);
    const Rendering rendering = renderAdaptively(adaptive, {.threads = context.threads()});
    requireFinite(rendering);
    context.progress().advance(progressSteps);
    const Real mean = static_cast<Real>(adaptive.paths()) / static_cast<Real>(adaptive.estimates().size());
    show(column++, "adaptive, the same time: " + std::to_string(std::lround(mean)),
         toneMapped(developed(adaptive, rendering), what.tone.exposure, what.tone.white));
    constexpr Real least = 16;
    constexpr Real most = 1024;
    show(column, "its paths", heatMap(adaptive, least, most));
    const int scale = 300;
    drawHeatScale(drawing, Vec2(gap + 4 * (shownWidth + gap) - scale - 40, top + shownHeight + 10), scale, least, most);
    drawing.save(context.output(name + ".png"));
}

}  // namespace

void drawBunny(const ChapterInputs& chapter, FigureContext& context) { drawStudy("bunny", 300, chapter, context); }

void drawCup(const ChapterInputs& chapter, FigureContext& context) { drawStudy("cup", 360, chapter, context); }

}  // namespace caustic
