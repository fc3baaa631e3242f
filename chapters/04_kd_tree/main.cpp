#include <iostream>

#include "chapter_inputs.h"
#include "figure/chapter.h"
#include "figures.h"
#include "inspect.h"

int main(int argc, char** argv) {
    using namespace caustic;
    std::string file;
    return runChapter(
        thisChapter, argc, argv,
        {
            {"bunnies", drawBunnies},
            {"splits", drawSplits},
            {"heat_map", drawHeatMap},
            {"speed_accuracy", chartSpeedAccuracy, true},
            {"speed", chartSpeed, true},
            {"scaling", chartScaling},
            {"failure", chartFailures},
        },
        {
            {.argument = {"--inspect", "FILE",
                          "Print what a mesh is (counts, bounds, closed or not, its tree, rays a second) as JSON",
                          TextValue{&file}},
             .run = [&](const ChapterOptions& options) { inspectMesh(file, options.seed, std::cout); },
             .uses = {"--seed"}},
        });
}
