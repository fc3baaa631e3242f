#pragma once

#include <cstdint>

#include "material/bsdf.h"

namespace caustic::test {

/// What every BSDF has to hold to, whatever its model. Frames are those that it was made with.

/// Probability that directions with the density pdfW fall as unevenly as those of sample do: directionProbability.
/// Samples of delta lobes have no density; they count as failed ones.
double bsdfProbability(const Bsdf& bsdf, const ShadingFrame& shading, const Vec3& wo, int samples, std::uint64_t seed);

/// Share of the light sent along wo that the surface gives back: ∫ f |cos| dw by quadrature, delta lobes added. In
/// energy, so at most 1 through a boundary, too.
/// @param accuracy  to which the quadrature goes
Color albedo(const Bsdf& bsdf, const ShadingFrame& shading, const Vec3& wo, Real accuracy);

/// The largest f |cos| / pdfW among samples, channel by channel, in energy: 1 or less for a model whose sampling is as
/// good as visible normals. Of delta lobes: f / pdfW.
Real largestWeight(const Bsdf& bsdf, const ShadingFrame& shading, const Vec3& wo, int samples, std::uint64_t seed);

/// How much f changes when two directions are swapped, relative to its value: 0 for reflection. Of transmission it is
/// radiance over the square of the index that has to stay the same. ng must be ns.
Real reciprocityError(const Bsdf& bsdf, const ShadingFrame& shading, const Vec3& a, const Vec3& b);

}  // namespace caustic::test
