#pragma once

#include "math/vector.h"

namespace caustic {

/// Maps of the unit square [0, 1)² to discs and directions. Each keeps equal areas equal up to the density that it
/// names, and neighbours close, so that evenly spread numbers stay evenly spread.

/// A uniform point of the unit disc: density 1/π over area. Source: Shirley, Chiu 1997, A Low Distortion Map between
/// Disk and Square.
Vec2 concentricDisc(const Vec2& u);

/// A direction with z ≥ 0 and density z/π over solid angle: a point of the disc, lifted to the sphere (Malley's
/// method).
Vec3 cosineHemisphere(const Vec2& u);

/// A uniform direction: density 1/(4π) over solid angle.
Vec3 uniformSphere(const Vec2& u);

/// A uniform direction within the angle of +z whose cosine is `cosLimit`: density 1/(2π (1 − cosLimit)).
Vec3 uniformCone(const Vec2& u, Real cosLimit);

/// A direction with z ≥ 0 and density (n + 1)/(2π) · zⁿ over solid angle.
/// @param exponent  n, at least 0
Vec3 powerHemisphere(const Vec2& u, Real exponent);

}  // namespace caustic
