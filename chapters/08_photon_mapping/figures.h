#pragma once

#include "figure/figure.h"

/// The chapter's figures, each drawn by one function; main.cpp is their table of contents.
namespace caustic {

/// The caustic in a gold ring: ring.png.
void drawRing(FigureContext& context);

/// Photons where they lie, what they look like as light, and with direct light sampled: photon_map.png.
void drawPhotonMap(FigureContext& context);

}  // namespace caustic
