#include "medium/equi_angular.h"

#include <algorithm>
#include <cmath>

#include "core/not_implemented.h"

namespace caustic {

PlaceOnRay sampleEquiAngular(const Ray& ray, Real tEnd, const Vec3& centre, Real u) {
    //! [ex-11.6]
    // In lengths of the direction: where the ray begins as seen from its nearest point to the centre, and how far that
    // is beside it. A centre on the ray would leave no angles; another distance gives a density that is as right.
    constexpr Real leastShare = 1e-6;
    const Vec3 way = ray.origin - centre;
    const Real squared = ray.direction.squaredNorm();
    const Real begin = way.dot(ray.direction) / squared;
    const Real reach = std::abs(begin) + std::min(tEnd, Real(1));
    const Real beside = std::max((way - begin * ray.direction).norm() / std::sqrt(squared), leastShare * reach);
    // From where the ray begins to its end, as a difference of arc tangents that loses no digits.
    const Real angle = std::isfinite(tEnd) ? std::atan2(beside * tEnd, beside * beside + begin * (begin + tEnd))
                                           : std::atan2(beside, begin);
    // Lesson, eq. (11.7), as the way from where the ray begins.
    const Real sine = std::sin(u * angle);
    const Real cosine = std::cos(u * angle);
    const Real t = (beside * beside + begin * begin) * sine / (beside * cosine - begin * sine);
    const Real along = begin + t;
    // Lesson, eq. (11.8): dθ/dt over all angles.
    return {std::clamp(t, Real(0), tEnd), beside / (angle * (beside * beside + along * along))};
    //! [ex-11.6]
}

}  // namespace caustic
