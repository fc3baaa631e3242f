#pragma once

#include "figure/figure.h"
#include "measures/pass_states.h"
#include "measures/runs.h"

/// The chapter's figures, each drawn by one function; main.cpp is their table of contents.
namespace caustic {

/// A glass of wine and its caustic: wine_glass.png.
void drawWineGlass(FigureContext& context);

/// The empty glass by one pass and by many, with as many photons: passes.png.
void drawPasses(FigureContext& context);

/// Two rays that leave the eye side by side, through the foot of the glass: rays.png.
void drawRays(FigureContext& context);

/// The same photons in one map and in passes: photon_maps.png.
void drawPhotonMaps(FigureContext& context);

/// Chapter 07's two scenes that no method of its own cleans: clean_box.png, clean_mirror.png.
void drawClean(FigureContext& context);

/// Error over seconds on a caustic in a mirror: speed_accuracy.csv and .png.
void chartSpeedAccuracy(ChapterRuns& runs, FigureContext& context);

/// Both rules in the caustic and in the dark: claims.csv and .png.
void chartClaims(ChapterRuns& runs, FigureContext& context);

/// How bias falls with passes: bias.csv and .png.
void chartBias(ChapterRuns& runs, FigureContext& context);

/// The radius over passes: radius.csv and .png.
void chartRadius(ChapterRuns& runs, FigureContext& context);

/// What the process keeps, over passes: memory.csv and .png.
void chartMemory(ChapterRuns& runs, FigureContext& context);

/// Where each method breaks, counted: failure.csv and .png.
void chartFailures(FigureContext& context);

/// What the lesson states beyond the charts: quantity.csv.
void tabulateQuantities(ChapterRuns& runs, FigureContext& context);

}  // namespace caustic
