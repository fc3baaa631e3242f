#pragma once

#include <array>
#include <cstdint>

#include "core/random.h"
#include "curve/bezier_curve.h"
#include "support/in_cube.h"
#include "surface/axis_ray.h"

namespace caustic::test {

/// A cubic profile of heights -1 to 1, of that size and moved up.
inline BezierCurve cubicProfile(const std::array<Real, 4>& x, Real size = 1, Real height = 0) {
    const auto at = [&](std::size_t i, Real y) { return Vec3(size * x[i], size * y + height, 0); };
    return BezierCurve({at(0, -1), at(1, -0.4), at(2, 0.3), at(3, 1)});
}

/// A ray through the cube that such a profile is turned within, of a direction of any length.
inline Ray rayThroughCube(std::uint64_t seed, std::uint64_t i, Real size = 1, Real height = 0) {
    Random random(seed, {i});
    const Vec3 from = 2 * inCube(random);
    const Vec3 direction = std::pow(10, random.uniform(-1, 1)) * size * (inCube(random) - from);
    return {size * from + Vec3(0, height, 0), direction};
}

/// f of RevolvedSegment at a point of the profile, from its definition.
template <typename Number>
Number equationOf(const AxisRay& ray, const Number& x, const Number& y) {
    const Number h = y - Number(ray.baseHeight);
    const Number rise(ray.rise);
    const Number near(ray.near);
    return rise * rise * (near * near - x * x) + 2 * Number(ray.drift) * rise * h + Number(ray.flatSquare) * h * h;
}

}  // namespace caustic::test
