#include <iostream>

#include "chapter_inputs.h"
#include "failures/print_roots.h"
#include "figure/chapter.h"
#include "figures.h"
#include "figures/profile_picture.h"
#include "measures/print_lathe.h"

int main(int argc, char** argv) {
    using namespace caustic;
    return runChapter(
        thisChapter, argc, argv,
        {
            {"convergence", drawConvergence},
            {"bodies", drawBodies},
            {"teapot", drawTeapot},
            {"miss_maps", drawMissMaps},
            {"speed_accuracy", chartSpeedAccuracy, true},
            {"failure", chartFailures},
            {"quantity", tabulateQuantities},
        },
        {
            {"--profile", "FILE", "Turn a profile (SVG or control points) around x = 0 and draw it to revolved.png",
             [](const std::string& file, const ChapterOptions& options) { drawProfile(file, options); }},
            {"--roots", "RAYS",
             "Hold so many rays of each set against brute-force subdivision; print as JSON what was missed",
             [](const std::string& rays, const ChapterOptions& options) {
                 printRoots(rays, options.seed, options.threads, std::cout);
             }},
            {"--lathe", "WIDTH", "Time a picture's rays at a vase; print as JSON how long they took and what they hit",
             [](const std::string& width, const ChapterOptions&) { printLathe(width, std::cout); }},
        });
}
