#include "image/color_space.h"

#include <algorithm>
#include <cmath>

namespace caustic {

Real srgbEncode(Real linear) {
    if (!(linear > 0)) return 0;  // a NaN too: a display shows black
    if (linear >= 1) return 1;
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

Real srgbDecode(Real encoded) {
    if (!(encoded > 0)) return 0;
    if (encoded >= 1) return 1;
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

Color srgbEncode(const Color& linear) {
    return {srgbEncode(linear.x()), srgbEncode(linear.y()), srgbEncode(linear.z())};
}

Color srgbDecode(const Color& encoded) {
    return {srgbDecode(encoded.x()), srgbDecode(encoded.y()), srgbDecode(encoded.z())};
}

Color hsvToRgb(Real hue, Real saturation, Real value) {
    // Each channel is a trapezium over the hue: full for a third of the turn around its own, with ramps of a sixth.
    const auto channel = [&](Real ownHue) {
        const Real turns = hue - ownHue;
        const Real distance = std::abs(turns - std::round(turns));
        const Real purity = std::clamp(2 - 6 * distance, Real(0), Real(1));
        return value * (1 - saturation * (1 - purity));
    };
    return {channel(0), channel(Real(1) / 3), channel(Real(2) / 3)};
}

}  // namespace caustic
