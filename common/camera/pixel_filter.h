#pragma once

#include "math/vector.h"

namespace caustic {

/// How much of a pixel's value comes from where: a density around the pixel's centre, in pixels.
class PixelFilter {
public:
    virtual ~PixelFilter() = default;

    /// Largest offset along either axis at which it isn't 0, in pixels.
    virtual Real radius() const = 0;

    /// Density at an offset from the pixel's centre; its integral is 1.
    virtual Real density(const Vec2& offset) const = 0;

    /// An offset with that density. Samples that are placed so all count the same.
    /// @param u  two uniform numbers in [0, 1)
    virtual Vec2 sample(const Vec2& u) const = 0;
};

}  // namespace caustic
