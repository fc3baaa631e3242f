#include "figures/shape_view.h"

#include <Eigen/Geometry>
#include <cmath>

#include "core/parallel.h"
#include "image/color_space.h"

namespace caustic {

namespace {

const Color background = srgbDecode(Color(0.97, 0.97, 0.96));

// Darker where the surface turns away from the eye, so that shapes look round.
Real facing(const Hit& hit, const Vec3& wo) { return 0.45 + 0.55 * std::abs(hit.ns.dot(wo)); }

Ray rayThrough(const View& view, const Vec2& place, Real aspect) {
    const Vec3 forward = (view.target - view.eye).normalized();
    const Vec3 right = forward.cross(view.up).normalized();
    const Vec3 up = right.cross(forward);
    const Vec3 across = view.height * (aspect * (place.x() - 0.5) * right + (0.5 - place.y()) * up);
    if (view.parallel) return {view.eye + across, forward};
    return {view.eye, (view.target + across - view.eye).normalized()};
}

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

Image drawShape(const Shape& shape, const View& view, int width, int height, int samples, const HitColor& color,
                int threads) {
    Image image(width, height);
    parallelFor(height, threads, [&](std::int64_t row) {
        for (int column = 0; column < width; ++column) {
            Color sum = Color::Zero();
            for (int sample = 0; sample < samples * samples; ++sample) {
                const Real x = column + (sample % samples + 0.5) / samples;
                const Real y = static_cast<Real>(row) + (sample / samples + 0.5) / samples;
                const Ray ray = rayThrough(view, Vec2(x / width, y / height), Real(width) / height);
                const std::optional<Hit> hit = shape.intersect(ray);
                sum += hit ? color(*hit, -ray.direction) : background;
            }
            image.set(column, static_cast<int>(row), sum / (samples * samples));
        }
    });
    return image;
}

}  // namespace caustic
