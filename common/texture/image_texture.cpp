#include "texture/image_texture.h"

#include <utility>

#include "core/check.h"
#include "texture/check_color.h"

namespace caustic {

ImageTexture::ImageTexture(std::shared_ptr<const Image> image, Lookup lookup, Wrap wrap, const Vec2& tiles)
    : image_(std::move(image)), lookup_(lookup), wrap_(wrap), tiles_(tiles) {
    checkArgument(image_ != nullptr, "image texture", "", "needs an image");
    for (const Real tile : tiles) checkPositive(tile, "image texture's tiles");
    const Color first = image_->at(0, 0);
    Color sum = Color::Zero();
    for (int y = 0; y < image_->height(); ++y) {
        for (int x = 0; x < image_->width(); ++x) {
            const Color color = image_->at(x, y);
            checkNotNegative(color, "image texture's colour");
            largest_ = largest_.max(color);
            sum += color;
            constant_ = constant_ && (color == first).all();
        }
    }
    mean_ = constant_ ? first : Color(sum / (Real(image_->width()) * image_->height()));
}

Color ImageTexture::at(const SurfacePoint& point) const {
    if (constant_) return mean_;  // what an interpolation makes of equal colours may differ in the last bit
    const Real x = point.uv.x() * tiles_.x() * image_->width();
    const Real y = (1 - point.uv.y() * tiles_.y()) * image_->height();
    return lookup_ == Lookup::Nearest ? image_->nearest(x, y, wrap_, wrap_) : image_->bilinear(x, y, wrap_, wrap_);
}

}  // namespace caustic
