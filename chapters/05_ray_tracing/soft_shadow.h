#pragma once

#include "scene/scene.h"

namespace caustic {

/// A penumbra that has a closed form: a square lamp [−1, 1]² of radiance 1 at height 2, a square plate [−1/2, 1/2]² at
/// height 1, a white floor at height 0. From a point of the floor the plate hides a rectangle of the lamp.
SceneDescription softShadowScene();

/// Radiance that the floor sends out at (x, z), by form factors: all of the lamp's less the hidden rectangle's.
/// Source: Lambert 1760; Howell, A Catalog of Radiation Heat Transfer Configuration Factors, B-3.
Real softShadow(Real x, Real z);

}  // namespace caustic
