#include "figures/plane_view.h"

#include <algorithm>
#include <cmath>

namespace caustic {

PlaneView::PlaneView(const Bounds2& world, const Bounds2& pixels)
    : scale_((pixels.sizes().array() / world.sizes().array()).minCoeff()),
      worldCentre_(world.center()),
      pixelCentre_(pixels.center()) {}

Vec2 PlaneView::toPixels(const Vec3& point) const {
    const Vec2 offset = scale_ * (point.head<2>() - worldCentre_);
    return pixelCentre_ + Vec2(offset.x(), -offset.y());
}

std::vector<Vec2> PlaneView::toPixels(const std::vector<Vec3>& points) const {
    std::vector<Vec2> places;
    for (const Vec3& point : points) places.push_back(toPixels(point));
    return places;
}

Bounds2 PlaneView::toPixels(const Bounds3& box) const {
    Bounds2 pixels(toPixels(box.min()));
    pixels.extend(toPixels(box.max()));
    return pixels;
}

std::vector<Vec3> samplePoints(const BezierCurve& curve, int count, Real from, Real to) {
    std::vector<Vec3> points;
    for (int i = 0; i <= count; ++i) points.push_back(curve.position(from + (to - from) * i / count));
    return points;
}

void drawDot(Drawing& drawing, const Vec2& place, Real radius, const Ink& ink) {
    drawing.circle(place, radius + 1.5, palette::white);
    drawing.circle(place, radius, ink);
}

void drawSymbol(Drawing& drawing, const Vec2& place, const std::string& symbol, const std::string& below,
                const std::string& above, const Ink& ink, Real size) {
    TextStyle style{size, ink, true, HorizontalAnchor::Left, VerticalAnchor::Middle};
    const Real width = drawing.textWidth(symbol, style);
    drawing.text(place - Vec2(width / 2, 0), symbol, style);
    style.size = Real(0.68) * size;
    style.bold = false;
    const Real right = width / 2 + Real(0.06) * size;
    if (!below.empty()) drawing.text(place + Vec2(right, Real(0.36) * size), below, style);
    if (!above.empty()) drawing.text(place + Vec2(right, Real(-0.38) * size), above, style);
}

void drawTitle(Drawing& drawing, const Vec2& place, const std::string& title, const std::string& explanation,
               Real size) {
    drawing.text(place, title, {size, palette::text, true});
    drawing.text(place + Vec2(0, Real(1.3) * size), explanation, {Real(0.7) * size, palette::dark});
}

Ink mixed(const Ink& a, const Ink& b, Real share) {
    const auto channel = [&](std::uint8_t from, std::uint8_t to) {
        return static_cast<std::uint8_t>(std::lround(from + (Real(to) - from) * share));
    };
    return {channel(a.red, b.red), channel(a.green, b.green), channel(a.blue, b.blue),
            a.alpha + (b.alpha - a.alpha) * share};
}

}  // namespace caustic
