#include "chapter_inputs.h"
#include "figure/chapter.h"
#include "figures.h"
#include "work.h"

int main(int argc, char** argv) {
    using namespace caustic;
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
            {"--recalibrate", "SECONDS",
             "Measure anew how much work each method of methods.png does so long; writes work.json",
             [](const std::string& seconds, const ChapterOptions&) { recalibrate(seconds, thisChapter); }},
        });
}
