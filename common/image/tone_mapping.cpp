#include "image/tone_mapping.h"

#include "core/check.h"

namespace caustic {

Color toneMapped(const Color& radiance, Real exposure, Real white) {
    const Real y = exposure * luminance(radiance);
    return exposure * radiance * ((1 + y / (white * white)) / (1 + y));
}

Image toneMapped(const Image& image, Real exposure, Real white) {
    checkPositive(exposure, "exposure");
    checkPositive(white, "white point");
    Image mapped(image.width(), image.height());
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) mapped.set(x, y, toneMapped(image.at(x, y), exposure, white));
    }
    return mapped;
}

}  // namespace caustic
