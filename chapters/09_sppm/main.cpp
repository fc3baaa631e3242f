#include <string>
#include <vector>

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
    std::vector<ChapterOption> options = renderOptions(wishes);
    options.insert(options.begin(),
                   {{"--passes", "N", "Passes in all; 0 for as many as there is time for",
                     RangedValue<std::int64_t>{&wishes.passes, 0, 1'000'000'000}},
                    {"--time", "SECONDS", "Computing time in all; 0 for as long as the passes take", time},
                    {"--rule", "RULE", "How the radius gets smaller", ChoiceValue{&wishes.rule, {"pass", "point"}}}});
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
             .run = [&](const ChapterOptions& given) { renderScene(scene, wishes, thisChapter, given); },
             .uses = {"--out", "--threads", "--seed", "--preview"},
             .options = options},
            {.argument = {"--errors", "SCENE",
                          "Render by each method for --time SECONDS of one thread, and write errors",
                          ChoiceValue{&scene, {"peers_box", "point_box", "mirror_caustic"}}},
             .run =
                 [&](const ChapterOptions& given) { timeMethods(scene, wishes.seconds, methods, thisChapter, given); },
             .uses = {"--out", "--seed"},
             .options = {{"--time", "SECONDS", "Computing time in all; 0 for as long as the passes take", time},
                         {"--methods", "WHICH", "Those that trace photons, or all",
                          ChoiceValue{&methods, {"photons", "all"}}}}},
            {.argument = {"--reference", "PICTURE", "Make a converged picture anew", ChoiceValue{&scene, references}},
             .run = [&](const ChapterOptions& given) { makeReference(scene, minutes, thisChapter, given); },
             .uses = {"--threads"},
             .options = {{"--minutes", "MINUTES", "On the wall", RangedValue<double>{&minutes, 1e-3, 1e5}}}},
        });
}
