#include "chapter_inputs.h"
#include "figure/chapter.h"
#include "figures.h"

int main(int argc, char** argv) {
    using namespace caustic;
    return runChapter(thisChapter, argc, argv,
                      {
                          {"depth_of_field", drawDepthOfField},
                          {"volume_light", drawVolumeLight},
                          {"glow", drawGlow},
                          {"speed_accuracy", chartSpeedAccuracy, true},
                          {"failure", chartFailures},
                          {"quantity", tabulateQuantities, true},
                      });
}
