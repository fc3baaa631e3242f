#include <iostream>

#include "chapter_inputs.h"
#include "failures/print_leaks.h"
#include "figure/chapter.h"
#include "figures.h"

int main(int argc, char** argv) {
    using namespace caustic;
    std::int64_t rays = 0;
    return runChapter(
        thisChapter, argc, argv,
        {
            {"primitives", drawPrimitives},
            {"hierarchy", drawHierarchy},
            {"acne", drawAcne},
            {"offset_map", chartOffsets},
            {"speed_accuracy", chartSpeedAccuracy, true},
            {"triangle", chartTriangles, true},
            {"failure", chartFailures},
            {"quantity", tabulateQuantities},
        },
        {
            {.argument = {"--leaks", "RAYS",
                          "Aim so many rays at the edges of closed meshes and so many at their vertices; print as JSON "
                          "how many of them each triangle test lets out",
                          RangedValue<std::int64_t>{&rays, 1, 1'000'000'000}},
             .run = [&](const ChapterOptions& options) { printLeaks(rays, options.seed, options.threads, std::cout); },
             .uses = {"--seed", "--threads"}},
        });
}
