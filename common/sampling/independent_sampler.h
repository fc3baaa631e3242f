#pragma once

#include "sampling/sampler.h"

namespace caustic {

/// Numbers that have nothing to do with each other: plain Monte Carlo.
class IndependentSampler final : public Sampler {
public:
    /// @param seed  of everything
    explicit IndependentSampler(std::uint64_t seed) : seed_(seed) {}

    Real number(const PathName& path, Dimension dimension) const override;
    Vec2 pair(const PathName& path, Dimension dimension) const override;

private:
    std::uint64_t seed_;
};

}  // namespace caustic
