#pragma once

#include "scene/scene_description.h"

namespace caustic {

/// A rectangle that scatters diffusely on both sides.
/// @param reflectance  each channel in [0, 1]
/// @throws InputError as Rectangle and DiffuseMaterial do
SceneObject diffuseRectangle(const Vec3& corner, const Vec3& edgeU, const Vec3& edgeV, const Color& reflectance);

/// A rectangle that shines on the side of edgeU × edgeV and reflects nothing.
/// @param radiance  W/(m²·sr)
/// @throws InputError as Rectangle does
SceneObject rectangleLamp(const Vec3& corner, const Vec3& edgeU, const Vec3& edgeV, const Color& radiance);

/// A ball that reflects all light as a mirror does.
/// @param radius  greater than 0
SceneObject mirrorBall(const Vec3& center, Real radius);

/// A ball of clear glass: at each angle it reflects and refracts what Fresnel's equations say.
/// @param radius  greater than 0
/// @param ior     index of refraction, greater than 0
SceneObject glassBall(const Vec3& center, Real radius, Real ior);

}  // namespace caustic
