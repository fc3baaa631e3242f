#pragma once

#include "figure/figure.h"
#include "measures/runs.h"

/// The chapter's figures, each drawn by one function; main.cpp is their table of contents.
namespace caustic {

/// Error over seconds of path tracing by each sampler: speed_accuracy.csv and .png.
void chartSpeedAccuracy(ChapterRuns& runs, FigureContext& context);

/// The same over paths a pixel: convergence.csv and .png.
void chartConvergence(ChapterRuns& runs, FigureContext& context);

/// The first 256 points of each sampler: samplers.png.
void drawSamplers(FigureContext& context);

/// Where 50,000 photons of a cone light land by each way of emission: emission.png.
void drawEmission(FigureContext& context);

/// How far off they are, by frequency: spectrum.csv and .png.
void chartSpectrum(FigureContext& context);

/// Chapter 05's bunny of glass, uniform and adaptive for the same time, and where the paths went: bunny.png.
void drawBunny(const ChapterInputs& chapter, FigureContext& context);

/// The same of the glass of wine by SPPM: cup.png.
void drawCup(const ChapterInputs& chapter, FigureContext& context);

/// Where each rule sends the same number of paths: rules.png.
void drawRules(FigureContext& context);

/// What each adaptive rule gains over uniform sampling: adaptive.csv and .png.
void chartAdaptive(ChapterRuns& runs, FigureContext& context);

/// Light from a lamp by four densities: importance.png.
void drawImportance(FigureContext& context);

/// Where each method breaks, counted: failure.csv and .png.
void chartFailures(FigureContext& context);

/// What the lesson states beyond the charts: quantity.csv.
void tabulateQuantities(ChapterRuns& runs, FigureContext& context);

}  // namespace caustic
