#include <iostream>

#include "chapter_inputs.h"
#include "failures/print_roots.h"
#include "figure/chapter.h"
#include "figures.h"
#include "figures/profile_picture.h"
#include "measures/print_lathe.h"

int main(int argc, char** argv) {
    using namespace caustic;
    std::string profile;
    std::int64_t rays = 0;
    std::int64_t width = 0;
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
            {.argument = {"--profile", "FILE",
                          "Turn a profile (SVG or control points) around x = 0 and draw it to revolved.png",
                          TextValue{&profile}},
             .run = [&](const ChapterOptions& options) { drawProfile(profile, options); },
             .uses = {"--out", "--quality", "--threads"}},
            {.argument =
                 {"--roots", "RAYS",
                  "Hold so many rays of each set against brute-force subdivision; print as JSON what was missed",
                  RangedValue<std::int64_t>{&rays, 10, 1'000'000'000}},
             .run = [&](const ChapterOptions& options) { printRoots(rays, options.seed, options.threads, std::cout); },
             .uses = {"--seed", "--threads"}},
            {.argument = {"--lathe", "WIDTH",
                          "Time a picture's rays at a vase; print as JSON how long they took and what they hit",
                          RangedValue<std::int64_t>{&width, 16, 2048}},
             .run = [&](const ChapterOptions&) { printLathe(static_cast<int>(width), std::cout); }},
        });
}
