#pragma once

#include <cstdint>

#include "figure/figure.h"
#include "image/image.h"
#include "integrator/render.h"

namespace caustic {

/// How a radiance is shown: see toneMapped.
struct PictureTone {
    Real exposure = 1;
    Real white = 4;
};

/// Renders a figure's picture, by the figure's threads.
/// @param passes    at least 1: paths a pixel, of most methods
/// @param progress  advanced by progressSteps; null for none
/// @return radiances
/// @throws std::runtime_error when a sample was no finite number
Image renderImage(Integrator& integrator, std::int64_t passes, FigureContext& context, Progress* progress = nullptr);

/// The same, tone-mapped.
Image takePicture(Integrator& integrator, std::int64_t passes, const PictureTone& tone, FigureContext& context);

}  // namespace caustic
