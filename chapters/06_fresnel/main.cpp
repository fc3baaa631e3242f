#include "chapter_inputs.h"
#include "figure/chapter.h"
#include "figures.h"

int main(int argc, char** argv) {
    using namespace caustic;
    return runChapter(thisChapter, argc, argv,
                      {
                          {"glass_without", drawGlassWithoutFresnel},
                          {"glass_with", drawGlassWithFresnel},
                          {"reflectance", chartReflectance},
                          {"roughness_sheet", drawRoughnessSheet},
                          {"speed_accuracy", chartSpeedAccuracy, true},
                          {"failure", chartFailures},
                          {"quantity", tabulateQuantities},
                      });
}
