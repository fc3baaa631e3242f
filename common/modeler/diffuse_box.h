#pragma once

#include <array>

#include "scene/scene_description.h"

namespace caustic {

/// One of a box's walls: a rectangle and what share of light it reflects.
struct BoxWall {
    Vec3 corner = Vec3::Zero();
    Vec3 edgeU = Vec3::UnitX();
    Vec3 edgeV = Vec3::UnitY();  ///< edgeU × edgeV points into the box
    Color reflectance = Color::Zero();
};

/// The empty box [−1, 1]³ with an open front, y = −1; z is up. Under the middle of the ceiling a square lamp shines
/// downwards.
struct DiffuseBox {
    Real lampSide = 0.6;   ///< of the square, m; in (0, 2)
    Real radiance = 12;    ///< of the lamp, W/(m²·sr)
    bool mirror = false;   ///< whether the left wall, x = −1, is a mirror and not diffuse
    Real mirrored = 0.95;  ///< share of light that the mirror reflects

    /// Floor, ceiling, back, right, and left unless it is a mirror.
    std::vector<BoxWall> diffuseWalls() const;

    /// The lamp, its normal downwards; the reflectance is 0. It hangs a ten-thousandth below the ceiling.
    BoxWall lamp() const;

    /// The whole, seen through its front from where the lamp is out of view, in mirrors too.
    /// @throws InputError for a size that is none of an image
    SceneDescription scene(int width, int height) const;
};

}  // namespace caustic
