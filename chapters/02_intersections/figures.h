#pragma once

#include "core/figure.h"

/// The chapter's figures, each drawn by one function; main.cpp is their table of contents.
namespace caustic {

/// Where each method breaks, counted: failure.csv and .png.
void chartFailures(FigureContext& context);

}  // namespace caustic
