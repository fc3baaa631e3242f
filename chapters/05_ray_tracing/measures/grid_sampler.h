#pragma once

#include "sampling/sampler.h"

namespace caustic {

/// Cell centres of a regular grid, the same for every pixel: stratified numbers without the jitter. What takes the
/// place of noise is a pattern.
class GridSampler final : public Sampler {
public:
    /// @param perAxis  cells per axis, at least 1
    explicit GridSampler(int perAxis) : perAxis_(perAxis) {}

    Real number(const PathName& path, Dimension) const override {
        const std::int64_t cells = std::int64_t{perAxis_} * perAxis_;
        return (static_cast<Real>(path.index % cells) + 0.5) / static_cast<Real>(cells);
    }
    Vec2 pair(const PathName& path, Dimension) const override {
        const std::int64_t cell = path.index % (std::int64_t{perAxis_} * perAxis_);
        return {(static_cast<Real>(cell % perAxis_) + 0.5) / perAxis_,
                (static_cast<Real>(cell / perAxis_) + 0.5) / perAxis_};
    }

private:
    int perAxis_;
};

}  // namespace caustic
