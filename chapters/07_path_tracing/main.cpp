#include <string>

#include "chapter_inputs.h"
#include "figure/chapter.h"
#include "figures.h"
#include "measures/measured_scenes.h"
#include "measures/needs_command.h"
#include "measures/reference_command.h"
#include "measures/timed_command.h"

int main(int argc, char** argv) {
    using namespace caustic;
    double seconds = 0;
    std::string scene = "peers_box";
    std::string picture;
    double minutes = 5;
    std::int64_t needs = 0;
    std::int64_t method = 2;
    std::int64_t samples = 1;
    const RangedValue<double> anyTime = {&seconds, 1e-6, 1e6};
    const auto last = [](const auto& list) { return static_cast<std::int64_t>(list.size()) - 1; };
    ChapterRuns runs(thisChapter.sourceDir);
    const auto shared = [&runs](void (*draw)(ChapterRuns&, FigureContext&)) {
        return [&runs, draw](FigureContext& context) { draw(runs, context); };
    };
    return runChapter(
        thisChapter, argc, argv,
        {
            {"methods", shared(drawMethods)},
            {"pyramid", drawPyramid},
            {"caustic", shared(drawCaustic)},
            {"speed_accuracy", shared(chartSpeedAccuracy), true},
            {"convergence", shared(chartConvergence)},
            {"failure", chartFailures},
            {"quantity", shared(tabulateQuantities)},
        },
        {
            {.argument = {"--time", "SECONDS", "Render a scene by each method so long and write errors", anyTime},
             .run = [&](const ChapterOptions& options) { renderTimed(seconds, scene, thisChapter, options); },
             .uses = {"--out", "--threads", "--seed"},
             .options = {{"--scene", "NAME", "What is rendered", ChoiceValue{&scene, measuredSceneNames()}}}},
            {.argument = {"--recalibrate", "SECONDS",
                          "Measure anew how much work each method does so long; writes work.json", anyTime},
             .run = [&](const ChapterOptions&) { recalibrate(seconds, thisChapter); }},
            {.argument = {"--trace", "NEEDS", "Only trace paths, for a profiler, in a scene of growing needs",
                          RangedValue<std::int64_t>{&needs, 0, last(needyScenes())}},
             .run = [&](const ChapterOptions&) { tracePaths(needs, method, samples); },
             .options = {{"--method", "NUMBER", "Which of the methods, in the order of the figures",
                          RangedValue<std::int64_t>{&method, 0, last(allMethods)}},
                         {"--samples", "PATHS", "Paths a pixel", RangedValue<std::int64_t>{&samples, 1, 1'000'000}}}},
            {.argument = {"--reference", "PICTURE", "Make a converged picture anew",
                          ChoiceValue{&picture, referenceNames()}},
             .run = [&](const ChapterOptions& options) { makeReference(picture, minutes, thisChapter, options); },
             .uses = {"--threads"},
             .options = {{"--minutes", "MINUTES", "Of all threads together, on the wall",
                          RangedValue<double>{&minutes, 1e-3, 1e5}}}},
        });
}
