#include "camera/thin_lens_camera.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "core/check.h"
#include "core/not_implemented.h"
#include "sampling/warp.h"

namespace caustic {

ThinLensCamera::ThinLensCamera(const Vec3& position, const Vec3& target, const Vec3& up, Real fieldOfView, int width,
                               int height, Real radius, Real focus)
    : pinhole_(position, target, up, fieldOfView, width, height),
      position_(position),
      right_((target - position).normalized().cross(up).normalized()),
      forward_((target - position).normalized()),
      pixelSize_(2 * std::tan(fieldOfView / 2) / Real(height)),
      radius_(radius),
      focus_(focus) {
    up_ = right_.cross(forward_);
    checkFinite(radius, "lens's radius");
    checkArgument(radius >= 0, "lens's radius", formatReal(radius), "must be at least 0");
    checkPositive(focus, "distance of the plane in focus");
}

Ray ThinLensCamera::sampleRay(const Vec2& film, const Vec2& lens) const {
    //! [ex-11.4]
    const Ray middle = pinhole_.sampleRay(film, lens);
    if (!hasLens()) return middle;
    const Vec3 offset = lensOffset(lens);
    const Vec3 inFocus = middle.direction * (focus_ / middle.direction.dot(forward_));
    return {position_ + offset, (inFocus - offset).normalized()};
    //! [ex-11.4]
}

std::optional<ImportanceSample> ThinLensCamera::sampleImportance(const Vec3& point, const Vec2& lens) const {
    if (!hasLens()) return pinhole_.sampleImportance(point, lens);
    const Vec3 offset = lensOffset(lens);
    const Vec3 at = position_ + offset;
    const Vec3 way = at - point;
    const Real distance = way.norm();
    if (!(distance > 0)) return std::nullopt;
    const Vec3 wi = way / distance;
    const Real cosine = -wi.dot(forward_);
    if (!(cosine > 0)) return std::nullopt;
    const auto seen = pinhole_.sampleImportance(position_ + throughFocus(offset, -wi), lens);
    if (!seen) return std::nullopt;
    const Real squared = cosine * cosine;
    // PBR, 3rd ed., 16.1.1: a pixel of unit area, spread over the lens: We |cos| dω dA = dx dA / (π r²),
    // dx = dω / (pixel² cos³).
    const Real pdfA = 1 / (std::numbers::pi * radius_ * radius_);
    const Real importance = pdfA / (pixelSize_ * pixelSize_ * squared * squared);
    return ImportanceSample{seen->film, importance, wi, distance, cosine, pdfA, at};
}

CameraPdf ThinLensCamera::pdf(const Ray& ray) const {
    if (!hasLens()) return pinhole_.pdf(ray);
    const Vec3 direction = ray.direction.normalized();
    const Real cosine = direction.dot(forward_);
    if (!(cosine > 0)) return {};
    const Vec3 seen = throughFocus(ray.origin - position_, direction);
    if (!(pinhole_.pdf({position_, seen}).pdfW > 0)) return {};
    const Real film = pixelSize_ * pixelSize_ * Real(width()) * Real(height());
    // PBR, 3rd ed., 16.1.1: uniform over the lens and, from each of its points, over the film.
    return {1 / (std::numbers::pi * radius_ * radius_), 1 / (film * cosine * cosine * cosine)};
}

Real ThinLensCamera::circleOfConfusion(Real depth) const {
    // Potmesil, Chakravarty 1981, eq. 4, with the film at distance 1: similar triangles.
    return 2 * radius_ * std::abs(depth - focus_) / (depth * focus_ * pixelSize_);
}

// From the lens's middle, m.
Vec3 ThinLensCamera::lensOffset(const Vec2& lens) const {
    const Vec2 disc = radius_ * concentricDisc(lens);
    return disc.x() * right_ + disc.y() * up_;
}

// From the lens's middle to where a ray meets the plane in focus.
// @param offset  of the lens point that it leaves
Vec3 ThinLensCamera::throughFocus(const Vec3& offset, const Vec3& direction) const {
    return offset + direction * (focus_ / direction.dot(forward_));
}

}  // namespace caustic
