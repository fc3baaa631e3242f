#pragma once

#include "sampling/sampler.h"

namespace caustic {

/// Halton's points with permuted digits for the dimensions that matter most, plain random numbers for the rest.
///
/// The ten dimensions are, with the bases in this order: film (or place of emission), lens (or direction of emission),
/// and at vertex 0 the point on the light, the direction, the choices of a light and of a lobe. Larger bases would need
/// more points than a pixel has before they are spread evenly together. Each pixel and each stream has permutations of
/// its own: its paths are spread evenly by their index, those of different pixels are independent.
class HaltonSampler final : public Sampler {
public:
    /// @param seed  of everything
    explicit HaltonSampler(std::uint64_t seed) : seed_(seed) {}

    Real number(const PathName& path, Dimension dimension) const override;
    Vec2 pair(const PathName& path, Dimension dimension) const override;

private:
    std::uint64_t seed_;
};

}  // namespace caustic
