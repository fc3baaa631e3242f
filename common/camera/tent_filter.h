#pragma once

#include <algorithm>
#include <cmath>

#include "camera/pixel_filter.h"

namespace caustic {

/// Falls linearly to nothing at the neighbours' centres, along both axes: smoother edges than the box gives.
class TentFilter final : public PixelFilter {
public:
    Real radius() const override { return 1; }
    Real density(const Vec2& offset) const override {
        return std::max(Real(0), 1 - std::abs(offset.x())) * std::max(Real(0), 1 - std::abs(offset.y()));
    }
    Vec2 sample(const Vec2& u) const override { return {alongAxis(u.x()), alongAxis(u.y())}; }

private:
    // The integral of 1 − |x| from −1 on, inverted.
    static Real alongAxis(Real u) { return u < 0.5 ? std::sqrt(2 * u) - 1 : 1 - std::sqrt(2 * (1 - u)); }
};

}  // namespace caustic
