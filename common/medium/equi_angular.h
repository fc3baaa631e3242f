#pragma once

#include "math/ray.h"

namespace caustic {

/// Result of sampleEquiAngular.
struct PlaceOnRay {
    Real t = 0;    ///< in lengths of the ray's direction
    Real pdf = 0;  ///< density over t, greater than 0
};

/// Picks a place on a ray, from t = 0 to tEnd, so that seen from a point beside it all places lie at evenly spread
/// angles: many where the ray is near the point, as light of a lamp there is bright. The density goes as one over the
/// squared distance from the point, and takes that singularity out of the light that a medium scatters along the ray.
/// Source: Kulla, Fajardo 2012, Importance Sampling Techniques for Path Tracing in Participating Media, Computer
/// Graphics Forum 31(4).
/// @param tEnd    greater than 0, in lengths of the ray's direction; may be infinite
/// @param centre  the point; may lie on the ray: then all is as if it lay a millionth of its distance beside it
/// @param u       uniform in [0, 1)
PlaceOnRay sampleEquiAngular(const Ray& ray, Real tEnd, const Vec3& centre, Real u);

}  // namespace caustic
