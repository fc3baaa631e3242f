#pragma once

#include <functional>
#include <numbers>
#include <span>

#include "math/vector.h"

namespace caustic::test {

/// A piece of the sphere of directions between two heights and two angles; all of it by default.
struct SpherePatch {
    double zLow = -1;
    double zHigh = 1;
    double angleLow = -std::numbers::pi;  ///< of atan2(y, x), rad
    double angleHigh = std::numbers::pi;
};

/// (angle, z) of a unit direction, as patches are measured.
Vec2 placeOnSphere(const Vec3& direction);

/// The unit direction at a place.
Vec3 directionAt(const Vec2& place);

/// Integral over solid angle, by Gauss's rule of 3 × 3 points on pieces that are halved both ways as long as that
/// changes the sum, at most 24 times.
/// @param tolerance  how much the halving of a piece may change
/// @param crowd      places (angle, z) where the integrand may have a peak that goes unseen between the points of the
///                   rule: pieces that hold more than 32 of them are halved, whatever they say
double sphereIntegral(const std::function<double(const Vec3&)>& integrand, const SpherePatch& patch, double tolerance,
                      std::span<Vec2> crowd);

/// Integral over all directions with z from `zLow` to `zLow` + 1, in 1024 pieces to begin with, so that no kink hides
/// between the points of the rule: to about 1e-5 of the integrand's largest values.
double hemisphereIntegral(const std::function<double(const Vec3&)>& integrand, double zLow);

}  // namespace caustic::test
