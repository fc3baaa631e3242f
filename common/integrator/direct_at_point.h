#pragma once

#include "integrator/light_choice.h"
#include "integrator/visible_point.h"

namespace caustic {

/// What a visible point scatters to the eye of the light that comes straight from the lamps: an estimate, W/(m²·sr).
/// One lamp is sampled; at a glossy surface, whose highlight such samples miss, a direction as well, and the two are
/// weighed against each other.
/// @param numbers  the path's
/// @param counts   what was asked of the scene is added
Color directAtPoint(const Scene& scene, const LightChoice& lights, const VisiblePoint& point,
                    const PathNumbers& numbers, RayCounts& counts);

}  // namespace caustic
