#pragma once

#include <cstdint>

#include "math/vector.h"
#include "sampling/dimension.h"
#include "sampling/pixel.h"

namespace caustic {

class Sampler;

/// Names one path among all of a picture.
struct PathName {
    std::uint64_t stream = 0;  ///< what kind of path: from the eye, from a light, a branch of either
    Pixel pixel;               ///< which pixel it belongs to
    std::int64_t index = 0;    ///< which of the pixel's paths, from 0
};

/// The uniform numbers of one path: a name and the sampler that knows them. A value; cheap to copy.
class PathNumbers {
public:
    /// The sampler is kept by reference.
    PathNumbers(const Sampler& sampler, const PathName& name) : sampler_(&sampler), name_(name) {}

    /// One number, uniform in [0, 1).
    Real number(Dimension dimension) const;

    /// Two numbers, uniform in [0, 1)², from this dimension and the next one.
    Vec2 pair(Dimension dimension) const;

    /// The numbers of something apart that happens to the same path: one of two rays that it splits into, one of
    /// several lights. Different labels give independent numbers.
    PathNumbers branch(std::uint64_t label) const;

    /// The numbers of the i-th of n samples that take the place of one. Together, those of all paths of the pixel are
    /// spread as evenly as the sampler spreads paths.
    PathNumbers part(int i, int n) const;

private:
    const Sampler* sampler_;
    PathName name_;
};

/// Where the uniform numbers of all paths come from. Knows no state: the same name gives the same numbers, whichever
/// thread asks and in whatever order.
///
/// Every number by itself is uniform in [0, 1), and so is every pair. How the numbers of different paths of a pixel
/// hang together is the sampler's art.
class Sampler {
public:
    virtual ~Sampler() = default;

    /// The numbers of a path.
    PathNumbers start(std::uint64_t stream, Pixel pixel, std::int64_t index) const {
        return {*this, {stream, pixel, index}};
    }

    /// One number of a path, in [0, 1).
    virtual Real number(const PathName& path, Dimension dimension) const = 0;

    /// Two numbers of a path, in [0, 1)².
    virtual Vec2 pair(const PathName& path, Dimension dimension) const = 0;
};

}  // namespace caustic
