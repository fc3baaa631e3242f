#pragma once

#include <vector>

#include "figure/figure.h"
#include "measures/methods.h"

namespace caustic {

/// How far off a method was after so much work.
struct ErrorPoint {
    Method method;
    std::int64_t passes = 0;
    double seconds = 0;  ///< of one thread's computing time
    Real error = 0;      ///< RMSE of all pixels
    Real bright = 0;     ///< relative RMSE of the pixels that the caustic lights: the brightest tenth
    Real dark = 0;       ///< relative RMSE of the darkest half
};

/// All methods on the caustic in the mirror, looked at after 1, 2, 4 … passes, as long as `seconds` of one thread
/// allow.
/// @param seconds      for the photon methods; the other two get ten times as much
std::vector<ErrorPoint> mirrorCausticErrors(double seconds, FigureContext& context);

}  // namespace caustic
