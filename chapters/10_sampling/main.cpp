#include "chapter_inputs.h"
#include "figure/chapter.h"
#include "figures.h"
#include "work.h"

int main(int argc, char** argv) {
    using namespace caustic;
    ChapterRuns runs;
    double part = 1;
    const auto shared = [&runs](void (*draw)(ChapterRuns&, FigureContext&)) {
        return [&runs, draw](FigureContext& context) { draw(runs, context); };
    };
    return runChapter(thisChapter, argc, argv,
                      {
                          {"bunny", [](FigureContext& context) { drawBunny(thisChapter, context); }},
                          {"cup", [](FigureContext& context) { drawCup(thisChapter, context); }},
                          {"rules", drawRules},
                          {"samplers", drawSamplers},
                          {"emission", drawEmission},
                          {"spectrum", chartSpectrum},
                          {"importance", drawImportance},
                          {"adaptive", shared(chartAdaptive), true},
                          {"speed_accuracy", shared(chartSpeedAccuracy), true},
                          {"convergence", shared(chartConvergence)},
                          {"failure", chartFailures},
                          {"quantity", shared(tabulateQuantities), true},
                      },
                      {
                          {.argument = {"--recalibrate", "PART",
                                        "Measure anew how many uniform passes take as long as the adaptive pictures, at "
                                        "that part of their width; writes work.json",
                                        RangedValue<double>{&part, 0.01, 1}},
                           .run = [&](const ChapterOptions&) { recalibrate(part, thisChapter); }},
                      });
}
