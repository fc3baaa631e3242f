#include "camera/pinhole_camera.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "core/check.h"
#include "core/not_implemented.h"
#include "image/image.h"

namespace caustic {

PinholeCamera::PinholeCamera(const Vec3& position, const Vec3& target, const Vec3& up, Real fieldOfView, int width,
                             int height)
    : position_(position), width_(width), height_(height) {
    checkImageSize(width, height, "camera's film");
    for (const Vec3& point : {position, target, up}) {
        for (const Real coordinate : point) checkFinite(coordinate, "camera's position, target and up");
    }
    checkPositive(fieldOfView, "camera's field of view");
    checkArgument(fieldOfView < std::numbers::pi, "camera's field of view", formatReal(fieldOfView),
                  "must be less than π");
    checkPositive((target - position).norm(), "camera's distance from its target");
    forward_ = (target - position).normalized();
    const Vec3 right = forward_.cross(up);
    checkArgument(right.norm() > 1e-9 * up.norm(), "camera's up", "", "must not be along the view");
    right_ = right.normalized();
    up_ = right_.cross(forward_);
    halfHeight_ = std::tan(fieldOfView / 2);
}

Ray PinholeCamera::sampleRay(const Vec2& film, const Vec2&) const {
    //! [ex-05.1]
    const Real x = (film.x() - Real(width_) / 2) * pixelSize();
    const Real y = (Real(height_) / 2 - film.y()) * pixelSize();
    return {position_, (forward_ + x * right_ + y * up_).normalized()};
    //! [ex-05.1]
}

std::optional<ImportanceSample> PinholeCamera::sampleImportance(const Vec3& point, const Vec2&) const {
    const Vec3 way = position_ - point;
    const Real distance = way.norm();
    if (!(distance > 0)) return std::nullopt;
    const Vec3 wi = way / distance;
    const auto film = filmPoint(-wi);
    if (!film) return std::nullopt;
    const Real cosine = -wi.dot(forward_);
    // PBR, 3rd ed., 16.1.1: a pixel at distance 1 has the area pixelSize², and is seen from the pinhole under cos³
    // times that: We |cos| dω = dx.
    const Real squared = cosine * cosine;
    const Real importance = 1 / (pixelSize() * pixelSize() * squared * squared);
    return ImportanceSample{*film, importance, wi, distance, cosine, 1, position_};
}

CameraPdf PinholeCamera::pdf(const Ray& ray) const {
    const Vec3 direction = ray.direction.normalized();
    if (!filmPoint(direction)) return {};
    const Real area = pixelSize() * pixelSize() * Real(width_) * Real(height_);
    const Real cosine = direction.dot(forward_);
    // PBR, 3rd ed., 16.1.1: uniform over the film, at distance 1.
    return {0, 1 / (area * cosine * cosine * cosine)};
}

// Of a pixel at distance 1; pixels are squares.
Real PinholeCamera::pixelSize() const { return 2 * halfHeight_ / Real(height_); }

// Where a unit direction meets the film; nothing behind the camera or beyond the film's edges.
std::optional<Vec2> PinholeCamera::filmPoint(const Vec3& direction) const {
    const Real along = direction.dot(forward_);
    if (!(along > 0)) return std::nullopt;
    const Real x = Real(width_) / 2 + direction.dot(right_) / (along * pixelSize());
    const Real y = Real(height_) / 2 - direction.dot(up_) / (along * pixelSize());
    if (!(x >= 0 && x < width_ && y >= 0 && y < height_)) return std::nullopt;
    return Vec2(x, y);
}

}  // namespace caustic
