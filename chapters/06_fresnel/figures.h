#pragma once

#include "figure/failures.h"

/// The chapter's figures, each drawn by one function; main.cpp is their table of contents.
namespace caustic {

/// Glass that refracts all light, as in chapter 05: glass_without.png.
void drawGlassWithoutFresnel(FigureContext& context);

/// The same, where the angle decides: glass_with.png.
void drawGlassWithFresnel(FigureContext& context);

/// Reflectance over the angle, of glass from both sides and of metals: reflectance.csv and .png.
void chartReflectance(FigureContext& context);

/// Metal and glass, from smooth to rough, alike or not along both tangents: roughness_sheet.png.
void drawRoughnessSheet(FigureContext& context);

/// Schlick's formula beside the exact one, visible normals beside others: time against error: speed_accuracy.csv and
/// .png.
void chartSpeedAccuracy(FigureContext& context);

/// What failure.csv counts: all methods on all kinds of cases, each case made at random.
std::vector<FailureRow> failureRows(const FailureTrials& trials);

/// Where each method breaks, counted: failure.csv and .png.
void chartFailures(FigureContext& context);

/// What the lesson states beyond the charts: quantity.csv.
void tabulateQuantities(FigureContext& context);

}  // namespace caustic
