#pragma once

#include "texture/texture.h"

namespace caustic {

/// The same colour everywhere.
class ConstantTexture final : public Texture {
public:
    /// @throws InputError unless every channel is finite and at least 0
    explicit ConstantTexture(const Color& color);

    Color at(const SurfacePoint&) const override { return color_; }
    Color largest() const override { return color_; }
    Color mean() const override { return color_; }
    bool constant() const override { return true; }

private:
    Color color_;
};

}  // namespace caustic
