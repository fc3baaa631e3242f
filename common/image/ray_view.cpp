#include "image/ray_view.h"

#include <Eigen/Geometry>

#include "core/parallel.h"
#include "image/color_space.h"

namespace caustic {

Ray rayThrough(const RayView& view, const Vec2& place, Real aspect) {
    const Vec3 forward = (view.target - view.eye).normalized();
    const Vec3 right = forward.cross(view.up).normalized();
    const Vec3 up = right.cross(forward);
    const Vec3 across = view.height * (aspect * (place.x() - 0.5) * right + (0.5 - place.y()) * up);
    if (view.parallel) return {view.eye + across, forward};
    return {view.eye, (view.target + across - view.eye).normalized()};
}

Image supersampled(int width, int height, int samples, const std::function<Color(const Vec2&)>& color, int threads) {
    Image image(width, height);
    parallelFor(height, threads, [&](std::int64_t row) {
        for (int column = 0; column < width; ++column) {
            Color sum = Color::Zero();
            for (int sample = 0; sample < samples * samples; ++sample) {
                const Real x = column + (sample % samples + 0.5) / samples;
                const Real y = static_cast<Real>(row) + (sample / samples + 0.5) / samples;
                sum += color(Vec2(x / width, y / height));
            }
            image.set(column, static_cast<int>(row), sum / (samples * samples));
        }
    });
    return image;
}

Image supersampled(const RayView& view, int width, int height, int samples,
                   const std::function<Color(const Ray&)>& color, int threads) {
    return supersampled(
        width, height, samples, [&](const Vec2& place) { return color(rayThrough(view, place, Real(width) / height)); },
        threads);
}

Color paperColor() { return srgbDecode(Color(0.97, 0.97, 0.96)); }

}  // namespace caustic
