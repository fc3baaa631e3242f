#include "texture/checker_texture.h"

#include <cmath>

#include "core/check.h"
#include "texture/check_color.h"

namespace caustic {

CheckerTexture::CheckerTexture(const Color& even, const Color& odd, Real side) : even_(even), odd_(odd), side_(side) {
    checkNotNegative(even, "checkerboard's colour");
    checkNotNegative(odd, "checkerboard's colour");
    checkPositive(side, "checkerboard's side");
}

Color CheckerTexture::at(const SurfacePoint& point) const {
    const Real square = std::floor(point.uv.x() / side_) + std::floor(point.uv.y() / side_);
    return std::fmod(square, 2) == 0 ? even_ : odd_;
}

}  // namespace caustic
