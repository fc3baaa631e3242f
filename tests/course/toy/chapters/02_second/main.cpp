#include "chapter_inputs.h"
#include "figure/chapter.h"

int main(int argc, char** argv) { return caustic::runChapter(thisChapter, argc, argv, {}); }
