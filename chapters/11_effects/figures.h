#pragma once

#include "figure/figure.h"

/// The chapter's figures, each drawn by one function; main.cpp is their table of contents.
namespace caustic {

/// The same still life by three lenses, focused on its middle: depth_of_field.png.
void drawDepthOfField(FigureContext& context);

/// A glass of wine in faint fog, which shows the light's way: volume_light.png.
void drawVolumeLight(FigureContext& context);

/// The light that fog scatters around a lamp, by three methods: glow.png.
void drawGlow(FigureContext& context);

/// Error over seconds: speed_accuracy.csv and .png.
void chartSpeedAccuracy(FigureContext& context);

/// Where each method breaks, counted: failure.csv and .png.
void chartFailures(FigureContext& context);

/// What the lesson states beyond the charts: quantity.csv.
void tabulateQuantities(FigureContext& context);

}  // namespace caustic
