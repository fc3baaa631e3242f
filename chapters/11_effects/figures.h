#pragma once

#include "figure/figure.h"

/// The chapter's figures, each drawn by one function; main.cpp is their table of contents.
namespace caustic {

/// The same still life by three lenses, focused on its middle: depth_of_field.png.
void drawDepthOfField(FigureContext& context);

}  // namespace caustic
