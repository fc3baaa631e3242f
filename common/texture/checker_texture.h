#pragma once

#include "texture/texture.h"

namespace caustic {

/// A checkerboard over the surface parameters.
class CheckerTexture final : public Texture {
public:
    /// @param even  colour of the squares at whose corner with the smaller u and v the sum of both numbers is even
    /// @param odd   of the others
    /// @param side  of a square, in units of u and v
    /// @throws InputError unless all channels are finite and at least 0 and the side is positive
    CheckerTexture(const Color& even, const Color& odd, Real side);

    Color at(const SurfacePoint& point) const override;
    Color largest() const override { return even_.max(odd_); }
    Color mean() const override { return (even_ + odd_) / 2; }

private:
    Color even_;
    Color odd_;
    Real side_;
};

}  // namespace caustic
