#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "camera/pixel_filter.h"
#include "core/byte_stream.h"
#include "image/image.h"
#include "sampling/pixel.h"

namespace caustic {

/// A sample that was no finite number.
struct BadSample {
    Pixel pixel;             ///< where
    std::int64_t index = 0;  ///< which of the pixel's samples
};

/// Gathers samples and makes them a picture. Sums are in double precision and in the order of the calls, so whoever
/// wants the same picture for any number of threads adds in a fixed order.
class Film {
public:
    /// @throws InputError when the size is not one of an image
    Film(int width, int height);

    /// Pixels in a row.
    int width() const { return width_; }
    /// Rows.
    int height() const { return height_; }

    /// Enters a sample of a pixel; the pixel shows their mean. Its place was chosen with the pixel filter's density, so
    /// all count the same. A value that isn't finite is left out, and counted.
    /// @param index  which of the pixel's samples it is, for the report of a bad one
    void add(Pixel pixel, std::int64_t index, const Color& value);

    /// Enters a contribution at any place of the film, spread over the pixels around by the filter: what a path from a
    /// light brings. The picture shows the sum divided by splatPaths.
    void splat(const Vec2& place, const Color& value, const PixelFilter& filter);

    /// Says that further paths have set out whose contributions are splats.
    void countSplatPaths(std::int64_t paths) { splatPaths_ += paths; }

    /// Adds what another film has gathered, pixel by pixel, as one sum each. So films that are merged in a fixed order
    /// make a fixed picture, bit for bit, wherever each of them was made. When the other film has at most one sample of
    /// each pixel and no splats, it is also what adding its samples to this one makes; a film's splats are summed
    /// among themselves first.
    /// @throws InputError when its size is another one
    void merge(const Film& next);

    /// Writes everything, exactly.
    /// @param picture  names what is rendered: scene, method, seed, and whatever else makes the picture another one
    void save(ByteWriter& to, std::string_view picture) const;

    /// Puts what was saved in the place of what was gathered.
    /// @throws InputError that names the file when it is no film, of another version, picture or size, cut short or
    ///         damaged; this film then stays as it was
    void load(ByteReader& from, std::string_view picture);

    /// Mean of a pixel's samples, splats included.
    Color value(Pixel pixel) const;

    /// How many samples a pixel has.
    std::int64_t samples(Pixel pixel) const { return counts_[offset(pixel)]; }

    /// The picture.
    Image image() const;

    /// How many samples were no finite numbers, and the first of them.
    std::int64_t badSamples() const { return badSamples_; }
    /// The first sample that was no finite number.
    const std::optional<BadSample>& firstBad() const { return firstBad_; }

private:
    std::size_t offset(Pixel pixel) const {
        return static_cast<std::size_t>(pixel.y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(pixel.x);
    }
    void countBad(Pixel pixel, std::int64_t index);

    int width_;
    int height_;
    std::vector<Color> sums_;
    std::vector<std::int64_t> counts_;
    std::vector<Color> splats_;  // empty until the first one
    std::int64_t splatPaths_ = 0;
    std::int64_t badSamples_ = 0;
    std::optional<BadSample> firstBad_;
};

}  // namespace caustic
