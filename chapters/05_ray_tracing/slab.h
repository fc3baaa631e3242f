#pragma once

#include "scene/scene.h"

namespace caustic {

/// A pane of thickness 1 that reflects a share of the light at both faces and absorbs within, and a lamp of radiance 1
/// behind it. A ray from (−1, 0, 0) along +x sees all reflections within the pane.
SceneDescription slabScene(Real reflectance, Real sigma);

/// What that ray sees, the series in closed form: (1 − R)² a / (1 − R² a²) with a = e^(−σ).
/// Source: Born, Wolf, Principles of Optics, 7.6, without interference.
Real slabTransmission(Real reflectance, Real sigma);

}  // namespace caustic
