#pragma once

#include "scene/scene_description.h"

namespace caustic {

/// A glass ball between a small square lamp and a floor: it gathers the lamp's light to a bright spot, a caustic. z is
/// up, the floor is z = 0.
struct CausticScene {
    Vec3 ball = {-0.8, 0, 1};  ///< its centre
    Real radius = 0.5;         ///< of the ball, m
    Real ior = 1.5;            ///< of the ball
    Vec3 lamp = {-2, 0, 2.5};  ///< centre of the lamp, which shines downwards
    Real lampSide = 0.1;       ///< of the square, m; greater than 0
    Real power = 60;           ///< of the lamp, W
    Real floor = 0.75;         ///< share of light that the floor reflects, in all colours

    /// Half the side of the square of floor around (0.3, 0, 0) that onFloor shows, m.
    static constexpr Real shown = 0.6;

    /// Radiance of the lamp, W/(m²·sr).
    Real radiance() const;

    /// Seen straight from above by a camera that stands beside the ball and has nothing but floor in view: a square of
    /// 2 · shown around (0.3, 0, 0), x to the right and y upwards.
    SceneDescription onFloor(int width) const;

    /// Seen from the side, the ball in view, and a mirror that stands behind both: the same caustic again, and through
    /// the ball.
    SceneDescription beforeMirror(int width, int height) const;
};

}  // namespace caustic
