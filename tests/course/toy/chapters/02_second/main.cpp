#include "chapter_inputs.h"
#include "core/chapter.h"

int main(int argc, char** argv) { return caustic::runChapter(thisChapter, argc, argv, {}); }
