#include "chapter_inputs.h"
#include "core/chapter.h"
#include "figures.h"

int main(int argc, char** argv) {
    using namespace caustic;
    return runChapter(thisChapter, argc, argv,
                      {
                          {"failure", chartFailures},
                      });
}
