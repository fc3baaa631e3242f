#include "texture/normal_map.h"

#include <cmath>
#include <string>
#include <utility>

#include "core/check.h"

namespace caustic {

namespace {

void checkNormals(const Image& normals) {
    for (int y = 0; y < normals.height(); ++y) {
        for (int x = 0; x < normals.width(); ++x) {
            const Color one = normals.at(x, y);
            if (one.isFinite().all() && one.z() > 0) continue;
            throw InputError({"normal map", 0}, formatReal(one.z()),
                             "the normal in column " + std::to_string(x) + ", row " + std::to_string(y) +
                                 " doesn't point out of the surface");
        }
    }
}

}  // namespace

NormalMap::NormalMap(Image normals, Lookup lookup, const Vec2& tiles)
    : normals_(std::move(normals)), lookup_(lookup), tiles_(tiles) {
    for (const Real tile : tiles) checkPositive(tile, "normal map's tiles");
    checkNormals(normals_);
}

Vec3 NormalMap::at(const Vec2& uv) const {
    const Real x = uv.x() * tiles_.x() * normals_.width();
    const Real y = (1 - uv.y() * tiles_.y()) * normals_.height();
    const Color found = lookup_ == Lookup::Nearest ? normals_.nearest(x, y, Wrap::Repeat, Wrap::Repeat)
                                                   : normals_.bilinear(x, y, Wrap::Repeat, Wrap::Repeat);
    return Vec3(found.matrix()).normalized();
}

Image decodedNormals(const Image& codes, PngDepth depth) {
    const Real middle = depth == PngDepth::Bits8 ? 128 : 32768;
    Image normals(codes.width(), codes.height());
    for (int y = 0; y < codes.height(); ++y) {
        for (int x = 0; x < codes.width(); ++x)
            normals.set(x, y, ((codes.at(x, y) * (2 * middle - 1)).round() - middle) / (middle - 1));
    }
    return normals;
}

Image normalsOfHeights(const Image& heights) {
    Image normals(heights.width(), heights.height());
    const auto height = [&](int x, int y) { return heights.nearest(x + 0.5, y + 0.5, Wrap::Repeat, Wrap::Repeat).x(); };
    for (int y = 0; y < heights.height(); ++y) {
        for (int x = 0; x < heights.width(); ++x) {
            // Of z = h(x, y) the normal is along (−∂h/∂x, −∂h/∂y, 1); rows go down, v goes up.
            const Real alongU = (height(x + 1, y) - height(x - 1, y)) / 2;
            const Real alongV = (height(x, y - 1) - height(x, y + 1)) / 2;
            const Vec3 normal = Vec3(-alongU, -alongV, 1).normalized();
            normals.set(x, y, normal.array());
        }
    }
    return normals;
}

}  // namespace caustic
