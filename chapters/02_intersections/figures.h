#pragma once

#include "figure/figure.h"

/// The chapter's figures, each drawn by one function; main.cpp is their table of contents.
namespace caustic {

/// Every shape with its normals and its u and v: primitives.png.
void drawPrimitives(FigureContext& context);

/// Groups of transformed groups: hierarchy.png.
void drawHierarchy(FigureContext& context);

/// Shadows that a fixed offset gets wrong at one scale or another: acne.png.
void drawAcne(FigureContext& context);

/// Which offsets work at which scale, in float and in double: offset_map.csv and .png.
void chartOffsets(FigureContext& context);

/// ns per test against error, for rays and spheres: speed_accuracy.csv and .png.
void chartSpeedAccuracy(FigureContext& context);

/// ns per test against leaks, for rays and triangles: triangle.csv and .png.
void chartTriangles(FigureContext& context);

/// Where each method breaks, counted: failure.csv and .png.
void chartFailures(FigureContext& context);

/// What the lesson states beyond the charts: quantity.csv.
void tabulateQuantities(FigureContext& context);

}  // namespace caustic
