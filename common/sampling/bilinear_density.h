#pragma once

#include "math/vector.h"

namespace caustic {

/// A density over the unit square that is bilinear between its corners' values. None is negative, and one is greater
/// than 0; in any unit.
struct BilinearDensity {
    Real at00 = 1;  ///< value at (0, 0)
    Real at10 = 1;  ///< at (1, 0)
    Real at01 = 1;  ///< at (0, 1)
    Real at11 = 1;  ///< at (1, 1)

    /// The mean of the corners' values, and so of all.
    Real mean() const { return (at00 + at10 + at01 + at11) / 4; }

    /// The value at a point of the square, not normalised: divided by mean() it is the density.
    Real value(const Vec2& at) const;

    /// A point of the square with that density: first its row, then its place within.
    /// Source: PBR, 4th ed., 2.3.2 (linear) and 2.4.2 (bilinear).
    /// @param u  two uniform numbers in [0, 1)
    Vec2 sample(const Vec2& u) const;
};

}  // namespace caustic
