#pragma once

#include "image/image.h"
#include "math/vector.h"

namespace caustic {

/// Where a direction lies on an equirectangular panorama.
///
/// World's z is up. u = 1/2 − atan2(y, x) / 2π in [0, 1]: the middle column looks along +x, and turning right
/// (clockwise seen from above, towards −y) goes right, so that a photographed panorama is not mirrored; the left and
/// right borders both look along −x. v = θ / π in [0, 1] with the angle θ from +z: the zenith is the top row, the nadir
/// the bottom one.
/// @param direction  any length but 0; at the poles, where every u is right, it is 1/2
Vec2 sphericalToUv(const Vec3& direction);

/// The unit direction at a place of the panorama; inverse of sphericalToUv. Any finite u (period 1), v in [0, 1].
Vec3 uvToSpherical(const Vec2& uv);

/// The colour of a panorama in a direction: bilinear, going round at the seam (left and right borders are neighbours);
/// at the poles the first and last rows go on.
/// @param direction  any length but 0
Color lookUpSpherical(const Image& panorama, const Vec3& direction);

}  // namespace caustic
