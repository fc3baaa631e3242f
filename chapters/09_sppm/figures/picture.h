#pragma once

#include "figure/figure.h"
#include "image/image.h"
#include "integrator/sppm.h"

namespace caustic {

/// How many steps of progress sppmPicture advances.
inline constexpr std::int64_t pictureSteps = 1000;

/// What SPPM makes of a scene after so many passes, with Sobol's numbers and a box filter.
/// @throws std::runtime_error when a sample was no finite number
Image sppmPicture(const Scene& scene, const SppmSettings& settings, std::int64_t passes, FigureContext& context);

}  // namespace caustic
