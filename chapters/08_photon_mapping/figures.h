#pragma once

#include "figure/failures.h"
#include "figure/figure.h"

/// The chapter's figures, each drawn by one function; main.cpp is their table of contents.
namespace caustic {

/// The caustic in a gold ring: ring.png.
void drawRing(FigureContext& context);

/// More or fewer photons an estimate, and larger or smaller discs: estimates.png.
void drawEstimates(FigureContext& context);

/// A caustic before a mirror by path tracing, from both ends, and by photons: methods.png.
void drawMethods(const ChapterInputs& chapter, FigureContext& context);

/// Error over seconds: speed_accuracy.csv and .png.
void chartSpeedAccuracy(FigureContext& context);

/// Blur and noise apart: bias.csv and .png.
void chartBias(FigureContext& context);

/// All methods on all kinds of cases, each case made at random and known in closed form.
std::vector<FailureRow> failureRows(const FailureTrials& trials);

/// Where each method breaks, counted: failure.csv and .png.
void chartFailures(FigureContext& context);

/// What the lesson states beyond the charts: quantity.csv.
void tabulateQuantities(FigureContext& context);

/// Photons where they lie, what they look like as light, and with direct light sampled: photon_map.png.
void drawPhotonMap(FigureContext& context);

}  // namespace caustic
