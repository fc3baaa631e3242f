#pragma once

#include <array>

#include "image/image.h"
#include "scene/scene.h"

namespace caustic {

/// A coloured floor, y = 0, lit by a rectangular lamp with nothing between, and no lamp in view. What its picture
/// should be is known in closed form.
class LitFloor {
public:
    /// Under a lamp: as smooth as light gets.
    /// @param width  of the square picture, pixels
    static LitFloor under(int width);

    /// Beside a lamp that stands on it like a wall, to the left of the picture: light comes from everywhere near by,
    /// from next to nowhere far away.
    static LitFloor beside(int width);

    /// What is rendered.
    const Scene& scene() const { return scene_; }

    /// Segments of a path: eye, floor, lamp.
    static constexpr int segments = 2;

    /// The mean radiance of each pixel: Lambert's formula for a polygon, integrated over the pixel by Gauss and
    /// Legendre's rule. Source: Lambert 1760, Photometria.
    Image truth() const;

private:
    using Corners = std::array<Vec3, 4>;
    LitFloor(const Corners& lamp, std::shared_ptr<const Camera> camera);

    Corners lamp_;
    Scene scene_;
};

}  // namespace caustic
