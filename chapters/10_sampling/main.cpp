#include "chapter_inputs.h"
#include "figure/chapter.h"
#include "figures.h"
#include "render_command.h"
#include "sampling/sampler_names.h"
#include "scenes.h"
#include "work.h"

int main(int argc, char** argv) {
    using namespace caustic;
    ChapterRuns runs;
    double part = 1;
    std::string scene = "bunny";
    RenderWishes wishes;
    const auto shared = [&runs](void (*draw)(ChapterRuns&, FigureContext&)) {
        return [&runs, draw](FigureContext& context) { draw(runs, context); };
    };
    return runChapter(
        thisChapter, argc, argv,
        {
            {"bunny", [](FigureContext& context) { drawBunny(thisChapter, context); }},
            {"cup", [](FigureContext& context) { drawCup(thisChapter, context); }},
            {"rules", drawRules},
            {"samplers", drawSamplers},
            {"emission", drawEmission},
            {"spectrum", chartSpectrum},
            {"importance", drawImportance},
            {"adaptive", shared(chartAdaptive), true},
            {"speed_accuracy", shared(chartSpeedAccuracy), true},
            {"convergence", shared(chartConvergence)},
            {"failure", chartFailures},
            {"quantity", shared(tabulateQuantities), true},
        },
        {
            {.argument = {"--render", "SCENE", "Render a scene with any sampler and any rule",
                          ChoiceValue{&scene, studyNames()}},
             .run = [&](const ChapterOptions& options) { renderScene(scene, wishes, thisChapter, options); },
             .uses = {"--out", "--threads", "--seed"},
             .options =
                 {{"--sampler", "NAME", "Where random numbers come from", ChoiceValue{&wishes.sampler, samplerNames()}},
                  {"--rule", "NAME", "Which pixels get further paths; uniform for all alike",
                   ChoiceValue{&wishes.rule, ruleNames()}},
                  {"--paths", "N", "Paths a pixel, on average", RangedValue<std::int64_t>{&wishes.paths, 1, 1 << 24}},
                  {"--tolerance", "SHARE", "Of the rule interval", RangedValue<double>{&wishes.tolerance, 1e-9, 1e3}},
                  {"--width", "PIXELS", "Of the picture", RangedValue<std::int64_t>{&wishes.width, 8, 4096}},
                  {"--checkpoint", "FILE", "Go on from this file when it is there, and write it",
                   TextValue{&wishes.checkpoint}}}},
            {.argument = {"--recalibrate", "PART",
                          "Measure anew how many uniform passes take as long as the adaptive pictures, at "
                          "that part of their width; writes work.json",
                          RangedValue<double>{&part, 0.01, 1}},
             .run = [&](const ChapterOptions&) { measureWork(part, thisChapter); }},
        });
}
