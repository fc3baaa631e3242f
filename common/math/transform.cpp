#include "math/transform.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/check.h"
#include "core/not_implemented.h"

namespace caustic {

namespace {

constexpr Real epsilon = std::numeric_limits<Real>::epsilon();

// Rows are normalised first, so that a map to kilometres and one to nanometres are as regular as the identity.
Mat3 checkedInverse(const Mat3& linear) {
    const Vec3 norms = linear.rowwise().norm();
    checkArgument(norms.minCoeff() > 0 && norms.allFinite(), "transform", formatReal(norms.minCoeff()),
                  "is singular: it must not flatten space");
    const Mat3 unitRows = norms.cwiseInverse().asDiagonal() * linear;
    const Real determinant = unitRows.determinant();
    // Three unit rows: the determinant is computed with an error of a few epsilons, so below that it may be zero.
    checkArgument(std::abs(determinant) > 16 * epsilon, "transform", formatReal(determinant),
                  "is singular: it must not flatten space");
    const Mat3 inverse = unitRows.inverse() * norms.cwiseInverse().asDiagonal();
    checkArgument(inverse.allFinite(), "transform", formatReal(norms.minCoeff()), "scales too far to be undone");
    return inverse;
}

bool isInfinite(const Bounds3& box) { return !box.min().allFinite() || !box.max().allFinite(); }

}  // namespace

Transform::Transform() : Transform(Mat3::Identity(), Vec3::Zero(), Mat3::Identity()) {}

Transform::Transform(const Mat3& linear, const Vec3& translation)
    : linear_(linear), translation_(translation), inverseLinear_(Mat3::Identity()) {
    for (const Real entry : linear.reshaped()) checkFinite(entry, "transform's linear part");
    for (const Real entry : translation) checkFinite(entry, "transform's translation");
    inverseLinear_ = checkedInverse(linear);
}

Transform::Transform(const Mat3& linear, const Vec3& translation, const Mat3& inverseLinear)
    : linear_(linear), translation_(translation), inverseLinear_(inverseLinear) {}

Transform Transform::translation(const Vec3& by) { return {Mat3::Identity(), by}; }

Transform Transform::scaling(const Vec3& factors) { return {Mat3(factors.asDiagonal()), Vec3::Zero()}; }

Transform Transform::rotation(const Vec3& axis, Real radians) {
    checkPositive(axis.norm(), "rotation axis's length");
    checkFinite(radians, "rotation angle");
    return {Eigen::AngleAxis<Real>(radians, axis.normalized()).toRotationMatrix(), Vec3::Zero()};
}

Transform Transform::inverse() const { return {inverseLinear_, -(inverseLinear_ * translation_), linear_}; }

Transform operator*(const Transform& left, const Transform& right) {
    return {left.linear_ * right.linear_, left.point(right.translation_)};
}

Vec3 Transform::normal(const Vec3& n) const {
    //! [ex-02.6]
    return (inverseLinear_.transpose() * n).normalized();
    //! [ex-02.6]
}

Bounds3 Transform::bounds(const Bounds3& box) const {
    if (box.isEmpty()) return box;
    if (isInfinite(box)) {
        const Real infinity = std::numeric_limits<Real>::infinity();
        return {Vec3::Constant(-infinity), Vec3::Constant(infinity)};
    }
    const Mat3 low = linear_ * box.min().asDiagonal();
    const Mat3 high = linear_ * box.max().asDiagonal();
    // Sums of four terms, each product rounded once: γ(4) of the sum of absolute values bounds the error.
    const Vec3 absolute = low.cwiseAbs().cwiseMax(high.cwiseAbs()).rowwise().sum() + translation_.cwiseAbs();
    const Vec3 rounding = 4 * epsilon * absolute;
    return {low.cwiseMin(high).rowwise().sum() + translation_ - rounding,
            low.cwiseMax(high).rowwise().sum() + translation_ + rounding};
}

SurfacePoint Transform::surfacePoint(const SurfacePoint& at) const {
    // The point itself carries errors of |linear| · magnitude + |translation|. A ray that leaves it comes back through
    // the inverse, whose errors reach the world amplified by |linear| · |inverse| (Skeel's condition number).
    const Vec3 world = point(at.point);
    const Mat3 forward = linear_.cwiseAbs();
    const Vec3 there = forward * Vec3::Constant(at.magnitude) + translation_.cwiseAbs();
    const Vec3 back = forward * (inverseLinear_.cwiseAbs() * (world.cwiseAbs() + translation_.cwiseAbs()));
    return {world, normal(at.ng), at.uv, std::max(there.maxCoeff(), back.maxCoeff())};
}

Real Transform::areaScale(const Vec3& n) const {
    return std::abs(linear_.determinant()) * (inverseLinear_.transpose() * n).norm();
}

}  // namespace caustic
