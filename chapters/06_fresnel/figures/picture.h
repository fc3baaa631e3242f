#pragma once

#include "figure/figure.h"
#include "image/image.h"
#include "integrator/integrator.h"

namespace caustic {

/// Renders perAxis² paths a pixel, and tone-maps.
/// @throws std::runtime_error when a sample was no finite number
Image takePicture(Integrator& integrator, int perAxis, FigureContext& context);

}  // namespace caustic
