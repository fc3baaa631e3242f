#include <string>
#include <vector>

#include "chapter_inputs.h"
#include "figure/chapter.h"
#include "figure/take_option.h"
#include "figures.h"
#include "measures/needs_command.h"
#include "measures/reference_command.h"
#include "measures/timed_command.h"

int main(int argc, char** argv) {
    using namespace caustic;
    std::vector<const char*> arguments(argv, argv + argc);
    const std::string scene = takeOption(arguments, "--scene", "peers_box");
    const std::string minutes = takeOption(arguments, "--minutes", "5");
    const std::string method = takeOption(arguments, "--method", "2");
    const std::string samples = takeOption(arguments, "--samples", "1");
    ChapterRuns runs(thisChapter.sourceDir);
    const auto shared = [&runs](void (*draw)(ChapterRuns&, FigureContext&)) {
        return [&runs, draw](FigureContext& context) { draw(runs, context); };
    };
    return runChapter(
        thisChapter, static_cast<int>(arguments.size()), arguments.data(),
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
            {"--time", "SECONDS",
             "Render by each method so long and write errors; with --scene diffuse_box, mirror_box, caustic or "
             "peers_box",
             [&scene](const std::string& seconds, const ChapterOptions& options) {
                 renderTimed(seconds, scene, thisChapter, options);
             }},
            {"--recalibrate", "SECONDS", "Measure anew how much work each method does so long; writes work.json",
             [](const std::string& seconds, const ChapterOptions&) { recalibrate(seconds, thisChapter); }},
            {"--trace", "SCENE",
             "Only trace paths, for a profiler: scene 0 to 4 of growing needs; with --method 0 to 4 and --samples",
             [&](const std::string& which, const ChapterOptions&) { tracePaths(which, method, samples); }},
            {"--reference", "PICTURE",
             "Make a converged picture anew: peers_box, caustic_mirror or caustic_floor; with --minutes of all threads",
             [&minutes](const std::string& picture, const ChapterOptions& options) {
                 makeReference(picture, minutes, thisChapter, options);
             }},
        });
}
