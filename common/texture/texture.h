#pragma once

#include "math/color.h"
#include "math/surface_point.h"

namespace caustic {

/// A colour that may vary over a surface: a reflectance (unitless, in [0, 1]) or an emitted radiance (W/(m²·sr)), as
/// its user says. Never changes once it is made.
class Texture {
public:
    virtual ~Texture() = default;

    /// The colour at a point.
    virtual Color at(const SurfacePoint& point) const = 0;

    /// The largest value of each channel: what energy is bounded by.
    virtual Color largest() const = 0;

    /// The mean over the surface parameters' unit square: what a light's power is reckoned with.
    virtual Color mean() const = 0;

    /// Whether it varies at all.
    virtual bool constant() const { return false; }
};

}  // namespace caustic
