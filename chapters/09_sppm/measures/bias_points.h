#pragma once

#include <string>
#include <vector>

#include "figure/figure.h"
#include "integrator/sppm.h"

namespace caustic {

/// How a method's bias falls: one pixel whose answer is known.
struct BiasCurve {
    std::string method;
    Real alpha = 0;                    ///< 1 for a radius that stays
    std::vector<std::int64_t> passes;  ///< 1, 2, 4 …
    std::vector<Real> bias;            ///< how much too dark the pixel is, as a share of the answer
    Real slope = 0;                    ///< of log bias over log passes, least squares over the last half of the points
    Real firstExpected = 0;            ///< bias of the first pass, in closed form
};

/// On SpotUnderMirror: rule ① with three values of α, rule ②, and a radius that stays.
std::vector<BiasCurve> biasCurves(FigureContext& context);

}  // namespace caustic
