#include "chapter_inputs.h"
#include "core/chapter.h"
#include "figures.h"

int main(int argc, char** argv) {
    using namespace caustic;
    return runChapter(thisChapter, argc, argv,
                      {
                          {"primitives", drawPrimitives},
                          {"hierarchy", drawHierarchy},
                          {"acne", drawAcne},
                          {"offset_map", chartOffsets},
                          {"speed_accuracy", chartSpeedAccuracy, true},
                          {"triangle", chartTriangles, true},
                          {"failure", chartFailures},
                          {"quantity", tabulateQuantities},
                      });
}
