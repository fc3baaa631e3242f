#pragma once

#include "figure/figure.h"

/// The chapter's figures, each drawn by one function; main.cpp is their table of contents.
namespace caustic {

/// Four balls in an even glow and in a hall, and under a small sun by even directions and by brightness:
/// environment.png.
void drawEnvironment(FigureContext& context);

/// An image on a board and a ball, nearest and bilinear, and one that shines: textures.png.
void drawTextures(FigureContext& context);

/// A ball smooth, hammered by nearest and bilinear normals, and with normals that aren't bent: normals.png.
void drawNormals(FigureContext& context);

/// A cup smooth and fluted by a raw and a smoothed map, and their caustics: cup.png.
void drawCup(FigureContext& context);

/// The same still life by three lenses, focused on its middle: depth_of_field.png.
void drawDepthOfField(FigureContext& context);

/// The final picture without this chapter, and with one part of it after the other: parts.png.
void drawParts(FigureContext& context);

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
