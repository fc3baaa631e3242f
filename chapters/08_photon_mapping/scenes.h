#pragma once

#include "scene/scene_description.h"

namespace caustic {

/// A gold ring on a pale floor, in the light of a lamp at a point. What its inner wall reflects gathers along a curve
/// with a cusp, which everybody knows from the bottom of a cup: no walk from the eye ever finds it, for nobody hits a
/// point. y is up.
SceneDescription goldRing(int width, int height);

/// Of the ring, m.
inline constexpr Real ringRadius = 1;

}  // namespace caustic
