#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

#include "core/parallel.h"
#include "core/random.h"
#include "leaving.h"
#include "math/frame.h"
#include "measures/reference_113bit.h"
#include "shape/ball.h"
#include "sphere_methods.h"

namespace caustic {

/// A way to meet a ray with a sphere, as charts and tables name it.
template <typename Scalar>
struct SphereMethod {
    std::string name;
    BasicInterval<Scalar> (*interval)(const VectorOf<Scalar>&, const VectorOf<Scalar>&, Scalar);
};

/// The four that are compared; "projection" is the library's.
template <typename Scalar>
std::vector<SphereMethod<Scalar>> sphereMethods() {
    return {{"textbook quadratic", textbookQuadratic<Scalar>},
            {"projection by Pythagoras", pythagorasProjection<Scalar>},
            {"projection", ballInterval<Scalar, 3>},
            {"stable quadratic", stableQuadratic<Scalar>}};
}

/// How many rays make a point of a chart, in a draft and in the report: the same error in both.
inline constexpr std::size_t chartedRays = 2000;

/// A ray as seen from its origin, and the sphere of radius 1 that it hits.
template <typename Scalar>
struct SphereCase {
    VectorOf<Scalar> toCenter;
    VectorOf<Scalar> direction;
};

/// Rays that pass the centre at most 0.9 radii aside, `distance` radii in front of the surface.
///
/// That is true of the numbers as they are rounded, since only those that meet it are taken: in float, 10⁷ radii away,
/// rounding alone moves a ray by more than half a radius.
template <typename Scalar>
std::vector<SphereCase<Scalar>> sphereCases(double distance, std::size_t count, std::uint64_t seed) {
    constexpr double farthestAside = 0.9;
    std::vector<SphereCase<Scalar>> cases;
    for (std::uint64_t i = 0; cases.size() < count; ++i) {
        Random random(seed, {static_cast<std::uint64_t>(distance), i});
        const Frame frame = Frame::around(randomDirection(random));
        const double aside = farthestAside * std::sqrt(random.uniform());
        const double angle = 2 * std::numbers::pi * random.uniform();
        const Vec3 toCenter = (distance + 1) * frame.n;
        const Vec3 target = toCenter + aside * (std::cos(angle) * frame.s + std::sin(angle) * frame.t);
        const SphereCase<Scalar> one = {toCenter.cast<Scalar>(), target.normalized().cast<Scalar>()};
        if (distanceAside113(one.toCenter, one.direction) <= farthestAside) cases.push_back(one);
    }
    return cases;
}

/// Root mean square of the relative error in the nearer t; a hit that is lost counts as 1. Summed in fixed order.
template <typename Scalar>
double sphereError(const SphereMethod<Scalar>& method, const std::vector<SphereCase<Scalar>>& cases, int threads) {
    std::vector<double> squares(cases.size());
    parallelFor(static_cast<std::int64_t>(cases.size()), threads, [&](std::int64_t i) {
        const auto& [toCenter, direction] = cases[static_cast<std::size_t>(i)];
        const auto found = method.interval(toCenter, direction, Scalar(1));
        double& square = squares[static_cast<std::size_t>(i)];
        square = 1;
        if (found.empty()) return;
        const Real113 truth = nearerRoot113<Scalar>(toCenter, direction, Scalar(1));
        const double relative = static_cast<double>((Real113(found.lower) - truth) / truth);
        square = relative * relative;
    });
    double sum = 0;
    for (const double square : squares) sum += square;
    return std::sqrt(sum / static_cast<double>(squares.size()));
}

}  // namespace caustic
