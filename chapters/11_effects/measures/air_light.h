#pragma once

#include "scene/scene_description.h"

namespace caustic {

/// A point lamp in the midst of a ball of fog, seen from within: of light that is scattered once there is a closed
/// form, up to an integral of a smooth function.
struct AirLight {
    Color sigmaA = {0.02, 0.03, 0.05};  ///< absorption coefficient of the fog, 1/m
    Color sigmaS = {0.15, 0.12, 0.1};   ///< scattering coefficient, 1/m
    Real g = 0.3;                       ///< mean cosine of the fog's phase function
    Real size = 3;                      ///< radius of the ball, m; its centre is 0
    Vec3 lamp = Vec3::Zero();
    Color intensity = {3, 2.6, 2};  ///< of the lamp, W/sr
    Vec3 eye = {0, -2, 0};          ///< looks at the lamp

    /// The whole, in a picture of this size; the lamp is in the middle.
    SceneDescription scene(int width, int height) const;

    /// Radiance that comes along a ray from the eye to the rim of the fog of what is scattered once, W/(m²·sr): over
    /// the angle seen from the lamp, by Gauss's rule. It shares nothing with what renders. Source: Sun, Ramamoorthi,
    /// Narasimhan, Nayar 2005, A Practical Analytic Single Scattering Model for Real Time Rendering, ACM TOG 24(3),
    /// eqs. 8 and 10.
    /// @param direction  unit; not straight to the lamp
    Color scatteredOnce(const Vec3& direction) const;
};

}  // namespace caustic
