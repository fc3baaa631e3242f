#include <iostream>

#include "chapter_inputs.h"
#include "figure/chapter.h"
#include "figures.h"
#include "inspect.h"

int main(int argc, char** argv) {
    using namespace caustic;
    return runChapter(
        thisChapter, argc, argv,
        {
            {"de_casteljau", drawDeCasteljau},
            {"tangent_hodograph", drawTangentHodograph},
            {"profiles", drawProfiles},
            {"arc_length", drawArcLength},
            {"bounds", drawBounds},
            {"image_tools", drawImageTools},
            {"speed_accuracy", chartSpeedAccuracy, true},
            {"length", chartLength, true},
            {"failure", chartFailures},
            {"quantity", tabulateQuantities},
        },
        {
            {"--inspect", "FILE[#PATH]",
             "Print the curves of a profile (control points or SVG) as JSON; #id or #number chooses a path",
             [](const std::string& profile, const ChapterOptions&) { inspectProfile(profile, std::cout); }},
        });
}
