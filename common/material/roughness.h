#pragma once

#include "math/real.h"

namespace caustic {

/// Whether facets of these roughnesses along and across are taken for a smooth surface: both below Ggx::smoothBelow.
bool looksSmooth(Real alphaX, Real alphaY);

/// Throws InputError unless both are in [0, 1].
void checkRoughness(Real alphaX, Real alphaY);

}  // namespace caustic
