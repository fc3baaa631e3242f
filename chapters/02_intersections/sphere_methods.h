#pragma once

#include <Eigen/Core>
#include <cmath>
#include <limits>

#include "math/interval.h"

namespace caustic {

/// Other ways to meet a ray with a sphere than the library's ballInterval, each in one precision throughout. They share
/// its signature: the centre seen from the ray's origin, the direction (of any length), the radius; the t within.
template <typename Scalar>
using VectorOf = Eigen::Matrix<Scalar, 3, 1>;

/// What all of them say of a miss.
template <typename Scalar>
BasicInterval<Scalar> noInterval() {
    return {std::numeric_limits<Scalar>::infinity(), -std::numeric_limits<Scalar>::infinity()};
}

/// a t² + b t + c = 0 with the formula that everybody knows.
template <typename Scalar>
BasicInterval<Scalar> textbookQuadratic(const VectorOf<Scalar>& toCenter, const VectorOf<Scalar>& direction,
                                        Scalar radius) {
    const Scalar a = direction.squaredNorm();
    const Scalar b = -2 * toCenter.dot(direction);
    const Scalar c = toCenter.squaredNorm() - radius * radius;
    const Scalar discriminant = b * b - 4 * a * c;
    if (!(discriminant >= 0)) return noInterval<Scalar>();
    const Scalar root = std::sqrt(discriminant);
    return {(-b - root) / (2 * a), (-b + root) / (2 * a)};
}

/// The report's projection to the letter: the distance from the foot to the centre by Pythagoras, too.
template <typename Scalar>
BasicInterval<Scalar> pythagorasProjection(const VectorOf<Scalar>& toCenter, const VectorOf<Scalar>& direction,
                                           Scalar radius) {
    const Scalar length = direction.norm();
    const Scalar foot = toCenter.dot(direction) / length;
    const Scalar distanceSquared = toCenter.squaredNorm() - foot * foot;
    const Scalar halfChordSquared = radius * radius - distanceSquared;
    if (!(halfChordSquared >= 0)) return noInterval<Scalar>();
    const Scalar half = std::sqrt(halfChordSquared);
    return {(foot - half) / length, (foot + half) / length};
}

/// The quadratic as numerical analysts write it: the discriminant from the vector between foot and centre (Hearn and
/// Baker), the root that doesn't cancel first, the other one as c / q (Press et al.).
/// Source: Haines, Günther, Akenine-Möller 2019, Ray Tracing Gems 7, with both of its remedies.
template <typename Scalar>
BasicInterval<Scalar> stableQuadratic(const VectorOf<Scalar>& toCenter, const VectorOf<Scalar>& direction,
                                      Scalar radius) {
    const Scalar a = direction.squaredNorm();
    const Scalar halfB = toCenter.dot(direction);
    const VectorOf<Scalar> fromFoot = toCenter - (halfB / a) * direction;
    const Scalar discriminant = radius * radius - fromFoot.squaredNorm();
    if (!(discriminant >= 0)) return noInterval<Scalar>();
    const Scalar q = halfB + std::copysign(std::sqrt(a * discriminant), halfB);
    const Scalar c = toCenter.squaredNorm() - radius * radius;
    const Scalar first = c / q;
    const Scalar second = q / a;
    return first < second ? BasicInterval<Scalar>{first, second} : BasicInterval<Scalar>{second, first};
}

}  // namespace caustic
