#pragma once

#include "figure/failures.h"

/// The chapter's figures, each drawn by one function; main.cpp is their table of contents.
namespace caustic {

/// De Casteljau's construction with the names of its points, and at four more parameters: de_casteljau.png.
void drawDeCasteljau(FigureContext& context);

/// A curve with its derivatives, and the same arrows from the origin: tangent_hodograph.png.
void drawTangentHodograph(FigureContext& context);

/// Three vessels: their profiles as splines with control polygons, joints and boxes, and what they make when revolved:
/// profiles.png.
void drawProfiles(FigureContext& context);

/// The same curve with beads at even parameters and at even lengths: arc_length.png.
void drawArcLength(FigureContext& context);

/// Three bounding boxes of one curve, and how sampling misses a pair of extrema: bounds.png.
void drawBounds(FigureContext& context);

/// What the course does with pictures, on one sheet (look-up, edges, files, colours, panoramas): image_tools.png.
void drawImageTools(FigureContext& context);

/// ns per evaluation against error for four ways to evaluate: speed_accuracy.csv and .png.
void chartSpeedAccuracy(FigureContext& context);

/// Error of the length against evaluations and time, chords and Gauss–Legendre: length.csv and .png.
void chartLength(FigureContext& context);

/// What failure.csv counts: all methods on all kinds of cases, each case made at random.
std::vector<FailureRow> failureRows(const FailureTrials& trials);

/// Where each method breaks, counted over random cases: failure.csv and .png.
void chartFailures(FigureContext& context);

/// What the lesson states and no chart shows, orders of convergence above all: quantity.csv.
void tabulateQuantities(FigureContext& context);

}  // namespace caustic
