#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/random.h"
#include "image/image.h"
#include "math/frame.h"

namespace caustic::test {

/// A panorama that is coloured, lopsided, black in places, bright in a few pixels, at a pole and at the seam too.
inline Image uglyMap(int width, int height, std::uint64_t seed, Real scale = 1) {
    Random random(seed, {77});
    Image image(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            if (random.uniform() < 0.4) continue;
            image.set(x, y, scale * Color(random.uniform(), 2 * random.uniform(), 0.3 * random.uniform()));
        }
    }
    image.set(0, height / 3, scale * Color(4, 1, 9));
    image.set(width / 2, 0, scale * Color(9, 6, 2));
    image.set(width - 1, height - 1, scale * Color(1, 3, 2));
    return image;
}

/// Axes that stand aslant in the world.
inline Frame slantedAxes() { return Frame::around(Vec3(0.4, -0.7, 0.3).normalized()); }

/// Whether two pictures are the same, bit for bit.
inline bool sameBits(const Image& a, const Image& b) { return std::ranges::equal(a.data(), b.data()); }

}  // namespace caustic::test
