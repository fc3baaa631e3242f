#pragma once

#include "sampling/sampler.h"

namespace caustic {

/// Jittered numbers: of every n² paths of a pixel in a row, one has its pair in each cell of an n × n grid, and one has
/// its number in each of n² equal intervals; at random within it. Which path gets which cell is shuffled for each
/// dimension, or the film's cells would always meet the same cells of the light.
/// Source: Cook 1986, Stochastic Sampling in Computer Graphics; shuffled dimensions: PBR 8.5.
class StratifiedSampler final : public Sampler {
public:
    /// @param seed     of everything
    /// @param perAxis  n, at least 1 and at most 4096
    /// @throws InputError otherwise
    StratifiedSampler(std::uint64_t seed, int perAxis);

    Real number(const PathName& path, Dimension dimension) const override;
    Vec2 pair(const PathName& path, Dimension dimension) const override;

private:
    std::uint32_t cellOf(const PathName& path, Dimension dimension) const;

    std::uint64_t seed_;
    std::uint32_t perAxis_;
};

}  // namespace caustic
