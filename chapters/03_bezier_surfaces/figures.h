#pragma once

#include "figure/figure.h"

/// The chapter's figures, each drawn by one function; main.cpp is their table of contents.
namespace caustic {

/// From which pixels Newton's method finds a revolved line segment and a revolved cubic, from one random start and from
/// a bracketing one: convergence.png and .csv.
void drawConvergence(FigureContext& context);

/// Bodies of revolution of cubic segments and of high degree: bodies.png.
void drawBodies(FigureContext& context);

/// The Utah teapot, its patches by colour and its normals: teapot.png.
void drawTeapot(FigureContext& context);

/// Where each start loses the nearest meeting of a vase: miss_maps.png.
void drawMissMaps(FigureContext& context);

/// Rays per second against wrong rays per million: speed_accuracy.csv and .png.
void chartSpeedAccuracy(FigureContext& context);

/// Where each method breaks, counted: failure.csv and .png.
void chartFailures(FigureContext& context);

/// What the lesson states beyond the charts: quantity.csv.
void tabulateQuantities(FigureContext& context);

}  // namespace caustic
