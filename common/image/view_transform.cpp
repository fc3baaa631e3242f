#include "image/view_transform.h"

#include <algorithm>

#include "core/check.h"

namespace caustic {

namespace {

constexpr Real scaleOfPoint = 100;

void checkBox(const Bounds2& box, const std::string& what) {
    checkArgument(!box.isEmpty() && box.min().allFinite() && box.max().allFinite(), what, "",
                  "must be a finite box that is not empty");
}

}  // namespace

ViewTransform::ViewTransform(const Vec2& world, const Vec2& pixel, Real scale) : scale_(scale) {
    checkPositive(scale, "scale of a view");
    origin_ = Vec2(pixel.x() - scale * world.x(), pixel.y() + scale * world.y());
    checkArgument(origin_.allFinite(), "point of a view", "", "must be finite");
}

ViewTransform ViewTransform::fit(const Bounds2& world, const Bounds2& pixels, Real margin) {
    checkBox(world, "world of a view");
    checkBox(pixels, "pixels of a view");
    const Vec2 room = (pixels.sizes().array() - 2 * margin).matrix();
    checkArgument(room.minCoeff() > 0, "margin of a view", formatReal(margin), "leaves no pixel to draw on");
    const Vec2 size = world.sizes();
    const bool isPoint = size.maxCoeff() <= 0;
    // A line parallel to an axis bounds the scale along its own axis only: the other quotient is infinite.
    const Real scale = isPoint ? scaleOfPoint : std::min(room.x() / size.x(), room.y() / size.y());
    return {world.center(), pixels.center(), scale};
}

Vec2 ViewTransform::toPixel(const Vec2& world) const {
    return {origin_.x() + scale_ * world.x(), origin_.y() - scale_ * world.y()};
}

Vec2 ViewTransform::toWorld(const Vec2& pixel) const {
    return {(pixel.x() - origin_.x()) / scale_, (origin_.y() - pixel.y()) / scale_};
}

}  // namespace caustic
