#pragma once

#include "core/figure.h"

/// The chapter's figures, each drawn by one function; main.cpp is their table of contents.
namespace caustic {

/// ns per evaluation against error for four ways to evaluate: speed_accuracy.csv and .png.
void chartSpeedAccuracy(FigureContext& context);

}  // namespace caustic
