#pragma once

#include "math/hit.h"

namespace caustic {

/// The shading normal that a normal map gives a point, bent where it must be so that no reflection goes into the
/// surface: seen by a mirror at such a point, the world would be black.
///
/// The map's axes are u's direction along the surface, v's (mirrored where the hit is left-handed), and ns. Where the
/// direction that wo is mirrored to by the normal lies below the surface, or as good as, the normal is turned towards
/// ng, in the plane of both, just as far as it takes. It is one for each wo, and so a BSDF that is built with it is not
/// reciprocal where normals are bent. Source: the aim, Reshetov, Soupikov, Mark 2010, Consistent Normal Interpolation,
/// ACM TOG 29(6); the bending in closed form is this course's.
/// @param at     with ns on ng's side
/// @param local  unit, in the map's axes; z > 0
/// @param wo     unit direction to where the path came from; on either side
/// @return unit, on ng's side; ns itself for a local of (0, 0, 1), where it needn't be bent, and where u has no
///         direction
Vec3 mappedNormal(const Hit& at, const Vec3& local, const Vec3& wo);

}  // namespace caustic
