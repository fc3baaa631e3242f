#pragma once

#include "math/bounds.h"
#include "math/ray.h"
#include "math/surface_point.h"

namespace caustic {

/// A linear map of space.
using Mat3 = Eigen::Matrix<Real, 3, 3>;

/// An affine map of space that can be undone: p ↦ linear · p + translation. It may scale unevenly, shear and mirror.
class Transform {
public:
    /// The identity.
    Transform();

    /// @throws InputError when an entry is not finite, or the linear part is singular to working precision
    Transform(const Mat3& linear, const Vec3& translation);

    /// Moves everything by the same vector.
    static Transform translation(const Vec3& by);

    /// A factor for each axis; negative ones mirror.
    /// @throws InputError when one is zero or not finite
    static Transform scaling(const Vec3& factors);

    /// @param axis     of any length but zero
    /// @param radians  counterclockwise when the axis points to the viewer
    static Transform rotation(const Vec3& axis, Real radians);

    /// The two parts of p ↦ linear · p + translation.
    const Mat3& linear() const { return linear_; }
    const Vec3& translation() const { return translation_; }

    /// The map that undoes this one.
    Transform inverse() const;

    /// First `right`, then `left`.
    friend Transform operator*(const Transform& left, const Transform& right);

    /// A point moves with the translation; a vector (a direction, a difference of points) doesn't.
    Vec3 point(const Vec3& p) const { return linear_ * p + translation_; }
    Vec3 vector(const Vec3& v) const { return linear_ * v; }

    /// The unit normal of the transformed surface, on the same side of it: by the inverse transpose of the linear part.
    Vec3 normal(const Vec3& n) const;

    /// The same ray seen in the other space. Its direction isn't normalised, so that t means the same in both.
    Ray ray(const Ray& ray) const { return {point(ray.origin), vector(ray.direction), ray.tMin, ray.tMax}; }

    /// A box around the transformed box, rounding included. An infinite box stays one.
    /// Source: Arvo 1990, Transforming Axis-Aligned Bounding Boxes, Graphics Gems.
    Bounds3 bounds(const Bounds3& box) const;

    /// Point, normal and magnitude of the transformed surface; uv stay.
    SurfacePoint surfacePoint(const SurfacePoint& at) const;

    /// Area of the image of a unit of area with unit normal n: |det linear| · |linear⁻ᵀ n|.
    Real areaScale(const Vec3& n) const;

private:
    Transform(const Mat3& linear, const Vec3& translation, const Mat3& inverseLinear);

    Mat3 linear_;
    Vec3 translation_;
    Mat3 inverseLinear_;
};

}  // namespace caustic
