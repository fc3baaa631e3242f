#pragma once

#include "integrator/photon_mapper.h"
#include "integrator/picture.h"

namespace caustic {

/// A picture by photon mapping, with the figure's seed and threads.
/// @param passes  paths a pixel
/// @return radiances
Image photonPicture(const Scene& scene, const PhotonMapperSettings& settings, std::int64_t passes,
                    FigureContext& context);

}  // namespace caustic
