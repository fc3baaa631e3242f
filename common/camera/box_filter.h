#pragma once

#include "camera/pixel_filter.h"

namespace caustic {

/// The pixel's own square, all of it alike.
class BoxFilter final : public PixelFilter {
public:
    Real radius() const override { return 0.5; }
    Real density(const Vec2& offset) const override { return offset.cwiseAbs().maxCoeff() <= 0.5 ? 1 : 0; }
    Vec2 sample(const Vec2& u) const override { return u - Vec2::Constant(0.5); }
};

}  // namespace caustic
