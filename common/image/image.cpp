#include "image/image.h"

#include <cmath>
#include <string>

#include "core/error.h"

namespace caustic {

namespace {

// Two neighbours along one axis and the weight of the second.
struct Neighbours {
    int first;
    int second;
    Real weight;
};

// Into [0, size]. Written so that even a NaN ends up inside: it must never become an index.
Real wrapped(Real x, int size, Wrap wrap) {
    if (wrap == Wrap::Repeat) x -= std::floor(x / size) * size;
    if (!(x > 0)) return 0;
    return x < size ? x : Real(size);
}

int wrapped(int i, int size, Wrap wrap) {
    if (i < 0) return wrap == Wrap::Repeat ? size - 1 : 0;
    if (i >= size) return wrap == Wrap::Repeat ? 0 : size - 1;
    return i;
}

Neighbours neighbours(Real x, int size, Wrap wrap) {
    const Real fromCentre = wrapped(x, size, wrap) - Real(0.5);
    const int below = static_cast<int>(std::floor(fromCentre));
    return {wrapped(below, size, wrap), wrapped(below + 1, size, wrap), fromCentre - below};
}

std::size_t valueCount(int width, int height) {
    checkImageSize(width, height, "image");
    return 3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
}

}  // namespace

void checkImageSize(std::int64_t width, std::int64_t height, const std::string& file) {
    // Division, as the product of two sides from a damaged header need not fit.
    if (width >= 1 && height >= 1 && width <= Image::mostPixels / height) return;
    throw InputError(
        {file, 0}, std::to_string(width) + " x " + std::to_string(height),
        "an image must have sides of at least 1 and at most " + std::to_string(Image::mostPixels) + " pixels");
}

Image::Image(int width, int height, const Color& fill)
    : width_(width), height_(height), data_(valueCount(width, height)) {
    for (std::size_t i = 0; i < data_.size(); ++i) data_[i] = static_cast<float>(fill[static_cast<int>(i % 3)]);
}

Color Image::nearest(Real x, Real y, Wrap wrapX, Wrap wrapY) const {
    const int column = static_cast<int>(wrapped(x, width_, wrapX));
    const int row = static_cast<int>(wrapped(y, height_, wrapY));
    return at(wrapped(column, width_, wrapX), wrapped(row, height_, wrapY));
}

Color Image::bilinear(Real x, Real y, Wrap wrapX, Wrap wrapY) const {
    const Neighbours h = neighbours(x, width_, wrapX);
    const Neighbours v = neighbours(y, height_, wrapY);
    const Color top = (1 - h.weight) * at(h.first, v.first) + h.weight * at(h.second, v.first);
    const Color bottom = (1 - h.weight) * at(h.first, v.second) + h.weight * at(h.second, v.second);
    return (1 - v.weight) * top + v.weight * bottom;
}

}  // namespace caustic
