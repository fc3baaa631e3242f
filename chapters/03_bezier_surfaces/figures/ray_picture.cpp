#include "figures/ray_picture.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/parallel.h"
#include "image/color_space.h"

namespace caustic {

Color paperColor() { return srgbDecode(Color(0.97, 0.97, 0.96)); }

Ray rayThrough(const Eye& eye, const Vec2& place, Real aspect) {
    const Vec3 forward = (eye.target - eye.place).normalized();
    const Vec3 right = forward.cross(eye.up).normalized();
    const Vec3 up = right.cross(forward);
    const Vec3 across = eye.height * (aspect * (place.x() - 0.5) * right + (0.5 - place.y()) * up);
    return {eye.place, (eye.target + across - eye.place).normalized()};
}

Image pictureOf(const Eye& eye, int width, int height, int samples, const RayColor& color, int threads) {
    Image image(width, height);
    parallelFor(height, threads, [&](std::int64_t row) {
        for (int column = 0; column < width; ++column) {
            Color sum = Color::Zero();
            for (int sample = 0; sample < samples * samples; ++sample) {
                const Real x = column + (sample % samples + 0.5) / samples;
                const Real y = static_cast<Real>(row) + (sample / samples + 0.5) / samples;
                sum += color(rayThrough(eye, Vec2(x / width, y / height), Real(width) / height));
            }
            image.set(column, static_cast<int>(row), sum / (samples * samples));
        }
    });
    return image;
}

Color litColor(const Hit& hit, const Vec3& wo, const Vec3& up, const Color& body) {
    const Vec3 side = up.cross(wo).normalized();
    const Vec3 lamp = (wo + 0.9 * up - 0.7 * side).normalized();
    const Vec3 normal = hit.ns.dot(wo) < 0 ? Vec3(-hit.ns) : hit.ns;
    const Real diffuse = 0.22 + 0.78 * std::max(Real(0), normal.dot(lamp));
    const Real shine = 0.5 * std::pow(std::max(Real(0), normal.dot((lamp + wo).normalized())), 80);
    return diffuse * body * (1 - shine) + shine;
}

}  // namespace caustic
