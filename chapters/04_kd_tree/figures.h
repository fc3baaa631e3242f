#pragma once

#include "figure/figure.h"

/// The chapter's figures, each drawn by one function; main.cpp is their table of contents.
namespace caustic {

/// The bunny in few triangles and in many, flat and smooth: bunnies.png.
void drawBunnies(FigureContext& context);

/// Where two builders cut space: splits.png.
void drawSplits(FigureContext& context);

/// How many nodes and triangles each pixel's ray looks at: heat_map.png.
void drawHeatMap(FigureContext& context);

/// Rays a second against build time and memory: speed.csv and .png.
void chartSpeed(FigureContext& context);

/// What a ray and a build cost from 100 triangles to a million: scaling.csv and .png, quantity.csv.
void chartScaling(FigureContext& context);

/// Vertex normals three ways: time against degrees off a surface that is known: speed_accuracy.csv and .png.
void chartSpeedAccuracy(FigureContext& context);

/// Where each method breaks, counted: failure.csv and .png.
void chartFailures(FigureContext& context);

}  // namespace caustic
