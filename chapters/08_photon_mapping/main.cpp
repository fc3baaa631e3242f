#include "chapter_inputs.h"
#include "figure/chapter.h"
#include "figures.h"
#include "work.h"

int main(int argc, char** argv) {
    using namespace caustic;
    double seconds = 0;
    return runChapter(
        thisChapter, argc, argv,
        {
            {"ring", drawRing},
            {"photon_map", drawPhotonMap},
            {"estimates", drawEstimates},
            {"methods", [](FigureContext& context) { drawMethods(thisChapter, context); }},
            {"speed_accuracy", chartSpeedAccuracy, true},
            {"bias", chartBias},
            {"failure", chartFailures},
            {"quantity", tabulateQuantities},
        },
        {
            {.argument = {"--recalibrate", "SECONDS",
                          "Measure anew how much work each method of methods.png does so long; writes work.json",
                          RangedValue<double>{&seconds, 1e-3, 1e6}},
             .run = [&](const ChapterOptions&) { recalibrate(seconds, thisChapter); }},
        });
}
