#pragma once

#include <string>

#include "core/random.h"
#include "light/light.h"

namespace caustic {

/// How the directions are picked in which a surface looks at the sky.
enum class SkyChoice {
    Even,        ///< all alike
    Cosine,      ///< as the surface scatters
    Brightness,  ///< as the map is bright
    Both         ///< one of the last two kinds each, weighed by the power heuristic
};

/// What charts call it.
std::string nameOf(SkyChoice choice);

/// An estimate of the irradiance that a map brings to a surface, W/m² in the second channel.
/// @param samples  at least 1; Both takes half of them of each kind, at least one
Real irradiance(const Light& map, const Vec3& normal, SkyChoice choice, int samples, Random& random);

/// The same by midpoints of a grid of 8 × 8 in each of the map's pixels: no density is asked.
Real referenceIrradiance(const Light& map, const Vec3& normal, int mapHeight);

}  // namespace caustic
