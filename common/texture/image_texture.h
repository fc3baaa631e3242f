#pragma once

#include <memory>

#include "image/image.h"
#include "texture/texture.h"

namespace caustic {

/// How an image is read between its pixels' centres.
enum class Lookup {
    Nearest,  ///< the pixel that covers the place: squares, seen close
    Bilinear  ///< the four pixels around it, weighted
};

/// An image laid on a surface by its u and v. u goes to the right and v upwards, as in OBJ files: (0, 0) is the lower
/// left corner, (1, 1) the upper right one, of each tile when it repeats.
class ImageTexture final : public Texture {
public:
    /// @param image  kept alive; every value finite and at least 0
    /// @param tiles  how often the image fits into a unit of u and of v; greater than 0
    /// @throws InputError otherwise
    explicit ImageTexture(std::shared_ptr<const Image> image, Lookup lookup = Lookup::Bilinear,
                          Wrap wrap = Wrap::Repeat, const Vec2& tiles = Vec2::Ones());

    Color at(const SurfacePoint& point) const override;
    Color largest() const override { return largest_; }

    /// Of the image: exact where whole tiles fit.
    Color mean() const override { return mean_; }

    /// Whether the image has a single colour.
    bool constant() const override { return constant_; }

private:
    std::shared_ptr<const Image> image_;
    Lookup lookup_;
    Wrap wrap_;
    Vec2 tiles_;
    Color largest_ = Color::Zero();
    Color mean_ = Color::Zero();
    bool constant_ = true;
};

}  // namespace caustic
