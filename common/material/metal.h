#pragma once

#include "math/color.h"

namespace caustic {

/// The complex index of refraction of a metal, n + ik, for each channel.
struct Metal {
    Color eta = Color::Ones();  ///< n, greater than 0
    Color k = Color::Zero();    ///< extinction, at least 0

    /// Relative to what surrounds it, as fresnelConductor wants it.
    /// @param ior  index of refraction of that, greater than 0
    Metal inside(Real ior) const { return {eta / ior, k / ior}; }

    /// Measured at room temperature, in vacuum, at 616.8, 548.6 and 450.9 nm for red, green and blue.
    /// Source: Johnson, Christy 1972, Optical Constants of the Noble Metals, Physical Review B 6, table I.
    static Metal gold();
    /// From the same table.
    static Metal silver();
    /// From the same table.
    static Metal copper();
};

/// Throws InputError unless n is finite and greater than 0, and k finite and at least 0.
void checkMetal(const Metal& metal);

}  // namespace caustic
