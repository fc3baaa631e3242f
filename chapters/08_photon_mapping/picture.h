#pragma once

#include "figure/figure.h"
#include "image/image.h"
#include "integrator/photon_mapper.h"

namespace caustic {

/// A picture by photon mapping, with the figure's seed and threads.
/// @param samples  paths a pixel
Image photonPicture(const Scene& scene, const PhotonMapperSettings& settings, std::int64_t samples,
                    FigureContext& context);

/// The same by any integrator.
Image pictureBy(Integrator& integrator, std::int64_t samples, FigureContext& context);

}  // namespace caustic
