#include "figures/shape_view.h"

#include <cmath>

#include "image/color_space.h"

namespace caustic {

namespace {

// Darker where the surface turns away from the eye, so that shapes look round.
Real facing(const Hit& hit, const Vec3& wo) { return 0.45 + 0.55 * std::abs(hit.ns.dot(wo)); }

}  // namespace

Color normalColor(const Hit& hit, const Vec3& wo) {
    return srgbDecode(Color((hit.ns.array() + 1) / 2)) * facing(hit, wo);
}

HitColor uvColor(const Vec2& squares) {
    return [squares](const Hit& hit, const Vec3& wo) {
        const Vec2 square = hit.uv.cwiseProduct(squares).array().floor();
        const bool dark = std::fmod(square.sum(), 2) != 0;
        const Vec2 share = hit.uv.array() - hit.uv.array().floor();
        const Color tint(0.25 + 0.75 * share.x(), 0.25 + 0.75 * share.y(), 0.55);
        return Color(srgbDecode(tint) * (dark ? 0.35 : 1) * facing(hit, wo));
    };
}

Image drawShape(const Shape& shape, const RayView& view, int width, int height, int samples, const HitColor& color,
                int threads) {
    return supersampled(
        view, width, height, samples,
        [&](const Ray& ray) {
            const std::optional<Hit> hit = shape.intersect(ray);
            return hit ? color(*hit, -ray.direction) : paperColor();
        },
        threads);
}

}  // namespace caustic
