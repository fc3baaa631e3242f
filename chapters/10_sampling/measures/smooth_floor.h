#pragma once

#include "image/image.h"
#include "scene/scene.h"

namespace caustic {

/// A coloured floor under a rectangular lamp, with nothing between: as smooth as light gets. What its picture should be is
/// known in closed form.
class SmoothFloor {
public:
    /// @param width  of the square picture, pixels
    explicit SmoothFloor(int width);

    /// Seen from below the lamp, which is out of view.
    const Scene& scene() const { return scene_; }

    /// Segments of a path: eye, floor, lamp.
    static constexpr int segments = 2;

    /// The mean radiance of each pixel: Lambert's formula for a polygon, integrated over the pixel by Gauss and Legendre's
    /// rule. Source: Lambert 1760, Photometria.
    Image truth() const;

private:
    Scene scene_;
};

}  // namespace caustic
