#include "camera/film.h"

#include <algorithm>
#include <cmath>

namespace caustic {

Film::Film(int width, int height) : width_(width), height_(height) {
    checkImageSize(width, height, "film");
    const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    sums_.assign(pixels, Color::Zero());
    counts_.assign(pixels, 0);
}

void Film::add(Pixel pixel, std::int64_t index, const Color& value) {
    if (!value.isFinite().all()) {
        countBad(pixel, index);
        return;
    }
    sums_[offset(pixel)] += value;
    ++counts_[offset(pixel)];
}

void Film::splat(const Vec2& place, const Color& value, const PixelFilter& filter) {
    if (!value.isFinite().all()) {
        countBad({static_cast<int>(place.x()), static_cast<int>(place.y())}, 0);
        return;
    }
    if (splats_.empty()) splats_.assign(sums_.size(), Color::Zero());
    const Real reach = filter.radius();
    // Pixels whose centre is within reach.
    const int left = std::max(0, static_cast<int>(std::ceil(place.x() - 0.5 - reach)));
    const int right = std::min(width_ - 1, static_cast<int>(std::floor(place.x() - 0.5 + reach)));
    const int top = std::max(0, static_cast<int>(std::ceil(place.y() - 0.5 - reach)));
    const int bottom = std::min(height_ - 1, static_cast<int>(std::floor(place.y() - 0.5 + reach)));
    for (int y = top; y <= bottom; ++y) {
        for (int x = left; x <= right; ++x)
            splats_[offset({x, y})] += filter.density({place.x() - x - 0.5, place.y() - y - 0.5}) * value;
    }
}

Color Film::value(Pixel pixel) const {
    const std::size_t i = offset(pixel);
    Color value = Color::Zero();
    if (counts_[i] > 0) value += sums_[i] / static_cast<Real>(counts_[i]);
    if (!splats_.empty() && splatPaths_ > 0) value += splats_[i] / static_cast<Real>(splatPaths_);
    return value;
}

Image Film::image() const {
    Image image(width_, height_);
    for (int y = 0; y < height_; ++y) {
        for (int x = 0; x < width_; ++x) image.set(x, y, value({x, y}));
    }
    return image;
}

void Film::countBad(Pixel pixel, std::int64_t index) {
    ++badSamples_;
    if (!firstBad_) firstBad_ = BadSample{pixel, index};
}

}  // namespace caustic
