#include <iostream>

#include "chapter_inputs.h"
#include "failures/print_leaks.h"
#include "figure/chapter.h"
#include "figures.h"

int main(int argc, char** argv) {
    using namespace caustic;
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
            {"--leaks", "RAYS",
             "Aim so many rays at the edges of closed meshes and so many at their vertices; print as JSON how "
             "many of them each triangle test lets out",
             [](const std::string& rays, const ChapterOptions& options) {
                 printLeaks(rays, options.seed, options.threads, std::cout);
             }},
        });
}
