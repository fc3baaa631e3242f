#include <string>

#include "chapter_inputs.h"
#include "figure/chapter.h"
#include "figures.h"
#include "measures/reference_command.h"
#include "measures/timed_command.h"
#include "render_command.h"
#include "scenes.h"

int main(int argc, char** argv) {
    using namespace caustic;
    std::string scene = "wine_glass";
    RenderWishes wishes;
    double minutes = 10;
    std::string methods = "photons";
    const RangedValue<double> time = {&wishes.seconds, 0, 1e6};
    const std::vector<std::string> references = {"peers_box", "point_box"};
    ChapterRuns runs;
    const auto shared = [&runs](void (*draw)(ChapterRuns&, FigureContext&)) {
        return [&runs, draw](FigureContext& context) { draw(runs, context); };
    };
    return runChapter(
        thisChapter, argc, argv,
        {
            {"wine_glass", drawWineGlass},
            {"passes", drawPasses},
            {"rays", drawRays},
            {"photon_maps", drawPhotonMaps},
            {"clean", drawClean},
            {"speed_accuracy", shared(chartSpeedAccuracy), true},
            {"claims", shared(chartClaims), true},
            {"bias", shared(chartBias)},
            {"radius", shared(chartRadius)},
            {"memory", shared(chartMemory), true},
            {"failure", chartFailures},
            {"quantity", shared(tabulateQuantities), true},
        },
        {
            {.argument = {"--render", "SCENE", "Render a scene pass by pass", ChoiceValue{&scene, sceneNames()}},
             .run = [&](const ChapterOptions& options) { renderScene(scene, wishes, thisChapter, options); },
             .uses = {"--out", "--threads", "--seed", "--preview"},
             .options = {{"--passes", "N", "Passes in all; 0 for as many as there is time for",
                          RangedValue<std::int64_t>{&wishes.passes, 0, 1'000'000'000}},
                         {"--time", "SECONDS", "Computing time in all; 0 for as long as the passes take", time},
                         {"--rule", "RULE", "How the radius gets smaller", ChoiceValue{&wishes.rule, {"pass", "point"}}},
                         {"--alpha", "ALPHA", "Of the rule, between 0 and 1", RangedValue<double>{&wishes.alpha, 0, 1}},
                         {"--radius", "METRES", "Of the first pass; 0 for the scene's own",
                          RangedValue<double>{&wishes.radius, 0, 1e6}},
                         {"--photons", "N", "Photons a pass", RangedValue<std::int64_t>{&wishes.photons, 1, 1 << 30}},
                         {"--checkpoint", "FILE", "Go on from this file when it is there, and write it",
                          TextValue{&wishes.checkpoint}},
                         {"--every", "N", "Passes between two checkpoints",
                          RangedValue<std::int64_t>{&wishes.every, 1, 1'000'000'000}}}},
            {.argument = {"--errors", "SCENE", "Render by each method for --time SECONDS of one thread, and write errors",
                          ChoiceValue{&scene, {"peers_box", "point_box", "mirror_caustic"}}},
             .run = [&](const ChapterOptions& options) {
                 timeMethods(scene, wishes.seconds, methods, thisChapter, options);
             },
             .uses = {"--out", "--seed"},
             .options = {{"--time", "SECONDS", "Computing time in all; 0 for as long as the passes take", time},
                         {"--methods", "WHICH", "Those that trace photons, or all",
                          ChoiceValue{&methods, {"photons", "all"}}}}},
            {.argument = {"--reference", "PICTURE", "Make a converged picture anew", ChoiceValue{&scene, references}},
             .run = [&](const ChapterOptions& options) { makeReference(scene, minutes, thisChapter, options); },
             .uses = {"--threads"},
             .options = {{"--minutes", "MINUTES", "On the wall", RangedValue<double>{&minutes, 1e-3, 1e5}}}},
        });
}
