#pragma once

#include <Eigen/Core>
#include <boost/multiprecision/cpp_bin_float.hpp>

namespace caustic {

/// A number with a fraction of 113 bits, as in IEEE 754's binary128: 60 bits more than a double.
using Real113 = boost::multiprecision::cpp_bin_float_quad;

/// |c × d|² in 113 bits, for what line and centre are seen from: it doesn't cancel as the difference of squares does.
template <typename Scalar>
Real113 crossSquared113(const Eigen::Matrix<Scalar, 3, 1>& c, const Eigen::Matrix<Scalar, 3, 1>& d) {
    const Real113 cx(c.x()), cy(c.y()), cz(c.z());
    const Real113 dx(d.x()), dy(d.y()), dz(d.z());
    const Real113 px = cy * dz - cz * dy;
    const Real113 py = cz * dx - cx * dz;
    const Real113 pz = cx * dy - cy * dx;
    return px * px + py * py + pz * pz;
}

/// a · b in 113 bits.
template <typename Scalar>
Real113 dot113(const Eigen::Matrix<Scalar, 3, 1>& a, const Eigen::Matrix<Scalar, 3, 1>& b) {
    return Real113(a.x()) * Real113(b.x()) + Real113(a.y()) * Real113(b.y()) + Real113(a.z()) * Real113(b.z());
}

/// How far from the centre the ray's line passes.
template <typename Scalar>
double distanceAside113(const Eigen::Matrix<Scalar, 3, 1>& toCenter, const Eigen::Matrix<Scalar, 3, 1>& direction) {
    return static_cast<double>(sqrt(crossSquared113(toCenter, direction) / dot113(direction, direction)));
}

/// The judge of every ray-sphere test: the smaller root of |t d - c|² = r² in 113 bits, for a ray that certainly hits.
///
/// It shares no code with what it judges. Its discriminant is a sum of squares of cross products (Lagrange's identity)
/// and doesn't cancel at 10⁷ radii any more than 14 of its 34 digits.
template <typename Scalar>
Real113 nearerRoot113(const Eigen::Matrix<Scalar, 3, 1>& toCenter, const Eigen::Matrix<Scalar, 3, 1>& direction,
                      Scalar radius) {
    const Real113 r(radius);
    const Real113 lengthSquared = dot113(direction, direction);
    const Real113 discriminant = lengthSquared * r * r - crossSquared113(toCenter, direction);
    return (dot113(toCenter, direction) - sqrt(discriminant)) / lengthSquared;
}

}  // namespace caustic
