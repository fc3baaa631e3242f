#include "figures/mesh_view.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "core/parallel.h"
#include "image/color_space.h"

namespace caustic {

Color paperColor() { return srgbDecode(Color(0.97, 0.97, 0.96)); }

MeshView viewOf(const Bounds3& box, const Vec3& from) {
    const Real radius = box.diagonal().norm() / 2;
    return {box.center() + 4 * radius * from.normalized(), box.center(), 1.45 * radius};
}

Ray rayThrough(const MeshView& view, const Vec2& place, Real aspect) {
    const Vec3 forward = (view.target - view.eye).normalized();
    const Vec3 right = forward.cross(Vec3::UnitY()).normalized();
    const Vec3 up = right.cross(forward);
    const Vec3 across = view.height * (aspect * (place.x() - 0.5) * right + (0.5 - place.y()) * up);
    return {view.eye, (view.target + across - view.eye).normalized()};
}

Image drawRays(const MeshView& view, int width, int height, int samples, const std::function<Color(const Ray&)>& color,
               int threads) {
    Image image(width, height);
    parallelFor(height, threads, [&](std::int64_t row) {
        for (int column = 0; column < width; ++column) {
            Color sum = Color::Zero();
            for (int sample = 0; sample < samples * samples; ++sample) {
                const Real x = column + (sample % samples + 0.5) / samples;
                const Real y = static_cast<Real>(row) + (sample / samples + 0.5) / samples;
                sum += color(rayThrough(view, Vec2(x / width, y / height), Real(width) / height));
            }
            image.set(column, static_cast<int>(row), sum / (samples * samples));
        }
    });
    return image;
}

Color plaster(const Hit& hit, const Vec3& wo) {
    const Vec3 normal = hit.ng.dot(wo) < 0 ? Vec3(-hit.ns) : hit.ns;
    const Real key = std::max(Real(0), normal.dot(Vec3(-0.5, 0.8, 0.6).normalized()));
    const Real fill = std::max(Real(0), normal.dot(Vec3(0.9, 0.1, 0.5).normalized()));
    const Real sky = 0.5 + 0.5 * normal.y();
    return Color(0.62, 0.56, 0.48) * key + Color(0.10, 0.13, 0.18) * fill + Color(0.08, 0.09, 0.11) * sky;
}

}  // namespace caustic
