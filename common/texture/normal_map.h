#pragma once

#include "image/image.h"
#include "image/image_file.h"
#include "texture/image_texture.h"

namespace caustic {

/// Normals over a surface's u and v, in its own axes: x along increasing u, y along increasing v, z away from the
/// surface. Laid on by u and v as an ImageTexture is; repeats.
class NormalMap {
public:
    /// @param normals  in the three channels; any length, finite, z greater than 0
    /// @param lookup   Bilinear normals are interpolated, then made unit length
    /// @throws InputError otherwise, with the pixel
    explicit NormalMap(Image normals, Lookup lookup = Lookup::Bilinear, const Vec2& tiles = Vec2::Ones());

    /// The unit normal at a place. Flat is (0, 0, 1) exactly.
    Vec3 at(const Vec2& uv) const;

private:
    Image normals_;
    Lookup lookup_;
    Vec2 tiles_;
};

/// What the codes of a PNG's red, green and blue stand for: (code − 128)/127, or (code − 32768)/32767. The middle code
/// is 0, or no map could say "flat".
/// @param codes  as loadImage reads them with Encoding::Linear
Image decodedNormals(const Image& codes, PngDepth depth);

/// The normals of a height field that repeats.
/// @param heights  the first channel counts; in the unit in which a pixel is 1 wide
Image normalsOfHeights(const Image& heights);

}  // namespace caustic
