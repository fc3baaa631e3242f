#pragma once

#include <cstdint>
#include <string>

#include "figure/figure.h"
#include "integrator/adaptive.h"
#include "scenes.h"

namespace caustic {

/// How the pictures of a study are made.
struct PictureWork {
    int width = 0;              ///< pixels
    AdaptiveSettings settings;  ///< of the adaptive one
    Real tolerance = 0;         ///< of its rule, the interval's
};

/// Of the bunny or the glass of wine, by quality.
PictureWork pictureWork(const std::string& study, Quality quality);

/// How many uniform passes take as long as the adaptive picture at report quality: measured once by --recalibrate, so
/// that pictures are the same on every machine. A draft has a quarter of them.
/// @throws InputError when work.json isn't what --recalibrate writes
std::int64_t uniformPasses(const std::string& study, const ChapterInputs& chapter, Quality quality);

/// Measures them anew and writes work.json.
/// @param part  of the picture's width, greater than 0 and at most 1: the larger the better
void measureWork(double part, const ChapterInputs& chapter);

}  // namespace caustic
