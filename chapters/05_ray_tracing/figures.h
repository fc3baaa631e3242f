#pragma once

#include "figure/failures.h"

/// The chapter's figures, each drawn by one function; main.cpp is their table of contents.
namespace caustic {

/// A ball that is diffuse, reflects, refracts: materials.png.
void drawMaterials(FigureContext& context);

/// A glass bunny, clear and green: beer_lambert.png.
void drawBeerLambert(FigureContext& context);

/// The shadow of a point, of a cone and of a rectangle: shadows.png.
void drawShadows(FigureContext& context);

/// Mirror and glass spheres in a box: box.png.
void drawBox(FigureContext& context);

/// The same box, a surface deeper from tile to tile: depth.png.
void drawDepth(FigureContext& context);

/// Shadow samples and recursion depth: time against error: speed_accuracy.csv and .png.
void chartSpeedAccuracy(FigureContext& context);

/// What failure.csv counts: all methods on all kinds of cases, each case made at random.
std::vector<FailureRow> failureRows(const FailureTrials& trials);

/// Where each method breaks, counted: failure.csv and .png.
void chartFailures(FigureContext& context);

/// What the lesson states beyond the charts: quantity.csv.
void tabulateQuantities(FigureContext& context);

}  // namespace caustic
