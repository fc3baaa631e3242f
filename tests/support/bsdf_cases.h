#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/random.h"
#include "material/bsdf.h"

namespace caustic::test {

/// A BSDF, where it stands, and where it is seen from.
struct BsdfCase {
    std::string name;
    ShadingFrame shading;
    Vec3 wo;
    std::shared_ptr<const Bsdf> bsdf;
};

/// A surface that faces anywhere, tangents turned anyhow, with ns = ng or, when it is smooth, with ns turned away from
/// ng by a quarter of a radian. Air above, `ior` below.
ShadingFrame anyPlace(Random& random, bool smooth, Real ior);

/// Chapter 05's models that spread light, each at 12 places: ns = ng and ns apart from ng, seen from outside and
/// inside, from above and aside.
std::vector<BsdfCase> earlierBsdfCases();

/// Rough gold and silver, 6 roughnesses along and across, at 12 places each.
std::vector<BsdfCase> roughConductorCases();

/// Rough glass of an index, 6 roughnesses along and across, at 12 places each.
/// @param ior  greater than 0, not 1
std::vector<BsdfCase> roughDielectricCases(Real ior);

}  // namespace caustic::test
