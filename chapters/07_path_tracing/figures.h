#pragma once

#include "figure/failures.h"
#include "measures/runs.h"

/// The chapter's figures, each drawn by one function; main.cpp is their table of contents.
namespace caustic {

/// The peers' box by all five methods in the same time: methods.png.
void drawMethods(ChapterRuns& runs, FigureContext& context);

/// Each strategy of bidirectional path tracing by itself, and weighted: pyramid.png.
void drawPyramid(FigureContext& context);

/// A caustic, its image in a mirror and through glass, by all five methods in the same time: caustic.png.
void drawCaustic(ChapterRuns& runs, FigureContext& context);

/// Error over seconds in four scenes, and errors after the same time: speed_accuracy.csv, .png and equal_time.csv.
void chartSpeedAccuracy(ChapterRuns& runs, FigureContext& context);

/// Error over samples in the same scenes: convergence.csv and .png.
void chartConvergence(ChapterRuns& runs, FigureContext& context);

/// What failure.csv counts: all methods on all kinds of cases, each case made at random.
std::vector<FailureRow> failureRows(const FailureTrials& trials);

/// Where each method breaks, counted: failure.csv and .png.
void chartFailures(FigureContext& context);

/// What the lesson states beyond the charts: quantity.csv.
void tabulateQuantities(ChapterRuns& runs, FigureContext& context);

}  // namespace caustic
