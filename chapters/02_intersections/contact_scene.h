#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "leaving.h"
#include "shape/ball.h"

namespace caustic {

/// A ball that hovers over a floor, in one precision throughout: what leaving a surface has to cope with.
///
/// The ball's radius is `scale`, and so, roughly, is every coordinate; it is scale / 2000 from the floor. The floor is
/// tilted, so that its points round as points do. Floor and ball are met as the library's Plane and Sphere do it.
template <typename Scalar>
class ContactScene {
public:
    using Vector = Eigen::Matrix<Scalar, 3, 1>;

    /// A place on one of the two surfaces.
    struct Point {
        Vector point;
        Vector normal;     ///< unit, outwards
        Scalar magnitude;  ///< as in SurfacePoint
        bool onBall;       ///< or else on the floor
    };

    /// Gap between ball and floor, in units of the scale.
    static constexpr Scalar gap = Scalar(1) / 2000;

    /// @param scale  the ball's radius
    explicit ContactScene(Scalar scale)
        : normal_(Vector(Scalar(0.2), Scalar(1), Scalar(-0.1)).normalized()),
          touch_(scale * Vector(Scalar(0.7), Scalar(0.3), Scalar(-0.9))),
          center_(touch_ + scale * (1 + gap) * normal_),
          radius_(scale) {}

    /// The floor's normal and where the ball comes closest to it; the ball's centre and radius.
    const Vector& normal() const { return normal_; }
    const Vector& touch() const { return touch_; }
    const Vector& center() const { return center_; }
    Scalar radius() const { return radius_; }

    /// The nearest point of ball or floor that the ray meets for t > 0.
    std::optional<Point> intersect(const Vector& origin, const Vector& direction) const {
        const Scalar ball = ballT(origin, direction);
        const Scalar floor = floorT(origin, direction);
        constexpr Scalar infinity = std::numeric_limits<Scalar>::infinity();
        if (ball == infinity && floor == infinity) return std::nullopt;
        return ball < floor ? ballPoint(origin + ball * direction) : floorPoint(origin + floor * direction);
    }

    /// Whether the ray meets the ball, the floor, for t > 0.
    bool meetsBall(const Vector& origin, const Vector& direction) const {
        return ballT(origin, direction) < std::numeric_limits<Scalar>::infinity();
    }
    bool meetsFloor(const Vector& origin, const Vector& direction) const {
        return floorT(origin, direction) < std::numeric_limits<Scalar>::infinity();
    }

    /// A point moved onto the ball, onto the floor.
    Point ballPoint(const Vector& near) const {
        const Vector normal = (near - center_).normalized();
        return {center_ + radius_ * normal, normal, center_.cwiseAbs().maxCoeff() + radius_, true};
    }
    Point floorPoint(const Vector& near) const {
        const Vector point = near - normal_.dot(near - touch_) * normal_;
        return {point, normal_, std::max(point.cwiseAbs().maxCoeff(), touch_.cwiseAbs().maxCoeff()), false};
    }

private:
    Scalar ballT(const Vector& origin, const Vector& direction) const {
        const auto inside = ballInterval<Scalar, 3>(center_ - origin, direction, radius_);
        if (inside.empty()) return std::numeric_limits<Scalar>::infinity();
        if (inside.lower > 0) return inside.lower;
        return inside.upper > 0 ? inside.upper : std::numeric_limits<Scalar>::infinity();
    }
    Scalar floorT(const Vector& origin, const Vector& direction) const {
        const Scalar t = normal_.dot(touch_ - origin) / normal_.dot(direction);
        return t > 0 ? t : std::numeric_limits<Scalar>::infinity();
    }

    Vector normal_;
    Vector touch_;
    Vector center_;
    Scalar radius_;
};

/// How far from the surface a ray starts: a fixed distance, or a share of the point's magnitude.
template <typename Scalar>
struct Offset {
    Scalar fixed = 0;
    Scalar relative = 0;

    /// The point, so far along its normal.
    auto apply(const typename ContactScene<Scalar>::Point& at) const {
        return typename ContactScene<Scalar>::Vector(at.point + (fixed + relative * at.magnitude) * at.normal);
    }
};

/// What went wrong on a contact scene.
struct ContactFailures {
    FailureCount selfHits;      ///< rays that leave ball or floor outwards and meet it at once
    FailureCount lostContacts;  ///< rays across the gap that start beyond the other side of it
};

/// Rays that leave ball and floor, in turn: from anywhere to anywhere outwards, and across the gap where it is
/// thinnest.
template <typename Scalar>
ContactFailures contactFailures(double scale, const Offset<Scalar>& offset, int rays, std::uint64_t seed) {
    using Vector = typename ContactScene<Scalar>::Vector;
    const ContactScene<Scalar> scene(static_cast<Scalar>(scale));
    const Scalar size = scene.radius();
    ContactFailures count = {{0, rays}, {0, rays}};
    for (int i = 0; i < rays; ++i) {
        Random random(seed, {static_cast<std::uint64_t>(i)});
        const bool fromBall = i % 2 == 0;
        const Vector anywhere = randomDirection(random).template cast<Scalar>();
        const auto at = fromBall ? scene.ballPoint(scene.center() + anywhere)
                                 : scene.floorPoint(scene.touch() + 2 * size * anywhere);
        Vector away = randomDirection(random).template cast<Scalar>();
        if (away.dot(at.normal) < 0) away = -away;
        const Vector start = offset.apply(at);
        if (fromBall ? scene.meetsBall(start, away) : scene.meetsFloor(start, away)) ++count.selfHits.failures;

        const Vector nearby = Scalar(0.005) * size * randomDirection(random).template cast<Scalar>();
        const auto below =
            fromBall ? scene.ballPoint(scene.touch() + nearby) : scene.floorPoint(scene.touch() + nearby);
        const Vector begin = offset.apply(below);
        // Within the ball, or jumped right over it.
        const bool pastBall =
            (begin - scene.center()).squaredNorm() < size * size || scene.normal().dot(begin - scene.center()) > 0;
        const bool beyond = fromBall ? scene.normal().dot(begin - scene.touch()) < 0 : pastBall;
        if (beyond) ++count.lostContacts.failures;
    }
    return count;
}

}  // namespace caustic
