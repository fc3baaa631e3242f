#include "figures/heat.h"

#include <algorithm>
#include <cmath>

namespace caustic {

Color heatOf(Real paths, Real least, Real most) {
    const Real part = std::clamp(std::log(paths / least) / std::log(most / least), Real(0), Real(1));
    const auto rise = [part](Real from, Real to) { return std::clamp((part - from) / (to - from), Real(0), Real(1)); };
    return Color(rise(0, 0.45), rise(0.3, 0.8), rise(0.7, 1)).square() + Color(0.004, 0.004, 0.02);
}

Image heatMap(const AdaptiveIntegrator& integrator, Real least, Real most) {
    const int width = integrator.estimates().width();
    const int height = integrator.estimates().height();
    Image map(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x)
            map.set(x, y, heatOf(std::max<Real>(1, static_cast<Real>(integrator.paths({x, y}))), least, most));
    }
    return map;
}

void drawHeatScale(Drawing& drawing, const Vec2& corner, int width, Real least, Real most) {
    Image strip(width, 1);
    for (int i = 0; i < width; ++i)
        strip.set(i, 0, heatOf(least * std::pow(most / least, (i + 0.5) / width), least, most));
    drawing.image(strip, {corner, corner + Vec2(width, 16)});
    for (Real value = least; value <= 1.001 * most; value *= 4) {
        const Real place = width * std::log(value / least) / std::log(most / least);
        drawing.text(corner + Vec2(place, 36), std::to_string(std::lround(value)),
                     {.size = 15, .horizontal = HorizontalAnchor::Centre});
    }
    drawing.text(corner + Vec2(-14, 14), "paths of a pixel", {.size = 15, .horizontal = HorizontalAnchor::Right});
}

}  // namespace caustic
