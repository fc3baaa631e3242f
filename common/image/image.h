#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "math/color.h"

namespace caustic {

/// What lies beyond the border of an image: the pixel at the border, or the image once more.
enum class Wrap {
    Clamp,  ///< the border's pixel goes on
    Repeat  ///< the image stands there once more
};

/// A picture in linear RGB, three floats a pixel, rows from the top.
///
/// Continuous coordinates are in pixels: x to the right in [0, width], y down in [0, height]; pixel (i, j) covers
/// [i, i+1] × [j, j+1] and its value stands at its centre (i + 0.5, j + 0.5). A texture coordinate u is x = u · width.
class Image {
public:
    /// More than this is refused; a panorama of 16384 × 8192 pixels (1.5 GiB) just fits.
    static constexpr std::int64_t mostPixels = std::int64_t{1} << 27;

    /// @param fill  colour of every pixel
    /// @throws InputError when a side is less than 1 or there are more than mostPixels
    Image(int width, int height, const Color& fill = Color::Zero());

    /// Size in pixels.
    /// Pixels in a row.
    int width() const { return width_; }
    /// Rows.
    int height() const { return height_; }

    /// The pixel in column x, row y; both must be inside.
    Color at(int x, int y) const {
        const float* pixel = &data_[offset(x, y)];
        return {Real(pixel[0]), Real(pixel[1]), Real(pixel[2])};
    }

    /// Gives the pixel in column x, row y another colour; both must be inside.
    /// Sets the pixel in column x, row y; both must be inside.
    void set(int x, int y, const Color& color) {
        float* pixel = &data_[offset(x, y)];
        for (int channel = 0; channel < 3; ++channel) pixel[channel] = static_cast<float>(color[channel]);
    }

    /// All values: red, green, blue of the first pixel of the first row, then the next pixel's.
    std::span<const float> data() const { return data_; }
    /// The same, to write to.
    std::span<float> data() { return data_; }

    /// The pixel that covers (x, y). Any finite coordinates.
    Color nearest(Real x, Real y, Wrap wrapX = Wrap::Clamp, Wrap wrapY = Wrap::Clamp) const;

    /// Bilinear interpolation between the four pixels whose centres surround (x, y): continuous, and exact where the
    /// picture is linear. Any finite coordinates; textures that tile take Wrap::Repeat.
    Color bilinear(Real x, Real y, Wrap wrapX = Wrap::Clamp, Wrap wrapY = Wrap::Clamp) const;

private:
    std::size_t offset(int x, int y) const {
        assert(x >= 0 && x < width_ && y >= 0 && y < height_);
        return 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x));
    }

    int width_;
    int height_;
    std::vector<float> data_;
};

/// Throws InputError unless an image of this size can be made.
/// @param file  what the message names as the place
void checkImageSize(std::int64_t width, std::int64_t height, const std::string& file);

}  // namespace caustic
