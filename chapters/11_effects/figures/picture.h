#pragma once

#include "figure/figure.h"
#include "image/image.h"
#include "integrator/picture.h"
#include "scene/scene.h"

namespace caustic {

/// A picture by path tracing with multiple importance sampling, tone-mapped.
/// @param paths  a pixel
Image tracedPicture(const Scene& scene, std::int64_t paths, const PictureTone& tone, FigureContext& context);

/// The same, radiances.
Image tracedImage(const Scene& scene, std::int64_t paths, FigureContext& context);

}  // namespace caustic
