#include <iostream>

#include "chapter_inputs.h"
#include "figure/chapter.h"
#include "figures.h"
#include "inspect.h"

int main(int argc, char** argv) {
    using namespace caustic;
    std::string profile;
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
            {.argument =
                 {"--inspect", "FILE[#PATH]",
                  "Print the curves of a profile (control points or SVG) as JSON; #id or #number chooses a path",
                  TextValue{&profile}},
             .run = [&](const ChapterOptions&) { inspectProfile(profile, std::cout); }},
        });
}
