#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "image/image.h"
#include "sampling/sampler.h"

namespace caustic {

/// Where the photons of a cone light land on a floor, as a picture of counts: the light stands 1 m above the middle,
/// the picture shows the lit disc's bounding square.
class PhotonPattern {
public:
    /// The report's number of photons, as 100 × 500 cells.
    static constexpr std::int64_t columns = 100;
    static constexpr std::int64_t rows = 500;
    static constexpr std::int64_t photons = columns * rows;

    /// @param width  of the picture, pixels
    PhotonPattern(const Sampler& sampler, int width, std::int64_t first, int threads);

    /// Photons in each pixel over those that should be in it, 0 outside the disc.
    Image picture() const;

    /// Power of the difference between counts and their mean, by direction and frequency: of photons without any order
    /// it is 1 on average at each frequency. A window takes the disc's edge away.
    struct Spectrum {
        std::vector<Real> power;  ///< mean over the ring of each frequency, in periods across the picture: from 0
        Real peak = 0;            ///< the largest of these, from 4 periods on: a pattern, where it is far above 1
        Real low = 0;             ///< mean power of 1 to lowest periods across the picture
    };
    /// Periods across the picture that count as low: blobs of a sixteenth of it and larger.
    static constexpr int lowest = 16;
    Spectrum spectrum() const;

private:
    Real expected(int x, int y) const;

    int width_;
    std::vector<Real> counts_;
};

/// One of the four ways to emit photons.
struct Emission {
    std::string name;
    std::unique_ptr<const Sampler> sampler;
};

/// Random, plain grid, jittered grid, grid with offsets.
std::vector<Emission> emissions(std::uint64_t seed);

}  // namespace caustic
