#pragma once

#include <cstdint>

#include "scene/scene.h"

namespace caustic {

/// A number that names the way which light takes to a ray: the objects that it meets, in their order, from which side,
/// and whether it goes through them. The path goes on over mirrors and through glass, by whichever is the likelier,
/// and ends at the first non-specular surface, where the scene ends, or after so many segments. Two rays of the
/// same number see the same thing in the same way; different ways have the same number by chance of 2⁻⁶⁴ only.
/// @param ray        unit direction, in the media that the camera stands in
/// @param maxLength  segments of the path at most, at least 1
/// @param counts     what is done in the scene is added
std::uint64_t pathHash(const Scene& scene, const Ray& ray, int maxLength, RayCounts& counts);

}  // namespace caustic
