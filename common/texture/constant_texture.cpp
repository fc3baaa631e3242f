#include "texture/constant_texture.h"

#include "texture/check_color.h"

namespace caustic {

ConstantTexture::ConstantTexture(const Color& color) : color_(color) { checkNotNegative(color, "texture's colour"); }

}  // namespace caustic
