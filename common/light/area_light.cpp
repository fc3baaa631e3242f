#include "light/area_light.h"

#include <cmath>
#include <numbers>
#include <utility>

#include "core/check.h"
#include "core/not_implemented.h"
#include "math/frame.h"
#include "math/spawn.h"
#include "sampling/warp.h"

namespace caustic {

namespace {

// The mean of 1 / pdfA over a grid: the area, exactly where the shape is sampled uniformly.
Real areaOf(const Shape& shape) {
    constexpr int side = 32;
    Real sum = 0;
    for (int i = 0; i < side * side; ++i) {
        const auto sample = shape.sampleArea({(i % side + 0.5) / side, (i / side + 0.5) / side});
        if (!sample) throw InputError({"area light", 0}, "", "its shape cannot be sampled");
        sum += 1 / sample->pdfA;
    }
    return sum / (side * side);
}

}  // namespace

AreaLight::AreaLight(std::shared_ptr<const Shape> shape, std::shared_ptr<const Texture> radiance)
    : shape_(std::move(shape)), radiance_(std::move(radiance)) {
    checkArgument(shape_ != nullptr, "area light", "", "needs a shape");
    checkArgument(radiance_ != nullptr, "area light", "", "needs a radiance");
    area_ = areaOf(*shape_);
}

std::optional<DirectSample> AreaLight::sampleDirect(const SurfacePoint& from, const Vec2& u) const {
    //! [ex-05.5]
    const auto sample = shape_->sampleArea(u);
    const Vec3 way = sample->at.point - from.point;
    const Real squared = way.squaredNorm();
    if (!(squared > 0)) return std::nullopt;
    const Vec3 wi = way / std::sqrt(squared);
    const Real cosine = -wi.dot(sample->at.ng);
    if (cosine <= 0) return std::nullopt;
    // Veach 1997, 8.2.2: from area to solid angle.
    const Real pdfW = sample->pdfA * squared / cosine;
    return DirectSample{wi, radiance_->at(sample->at), pdfW, spawnRayTo(from, sample->at), sample->at};
    //! [ex-05.5]
}

Real AreaLight::pdfW(const Vec3& from, const SurfacePoint& on) const {
    const Vec3 way = on.point - from;
    const Real squared = way.squaredNorm();
    const Real cosine = -way.dot(on.ng) / std::sqrt(squared);
    // Veach 1997, 8.2.2: from area to solid angle.
    return cosine > 0 ? shape_->pdfA(on) * squared / cosine : 0;
}

std::optional<EmissionSample> AreaLight::sampleEmission(const Vec2& uPlace, const Vec2& uDirection) const {
    const auto sample = shape_->sampleArea(uPlace);
    const Vec3 local = cosineHemisphere(uDirection);
    if (!(local.z() > 0)) return std::nullopt;
    const Vec3 direction = Frame::around(sample->at.ng).toWorld(local);
    // PBR, 3rd ed., 16.1.2: a point of the shape; the direction has the density of cosineHemisphere.
    return EmissionSample{spawnRay(sample->at, direction), sample->at.ng, radiance_->at(sample->at), sample->pdfA,
                          local.z() * std::numbers::inv_pi};
}

EmissionPdf AreaLight::pdfEmission(const SurfacePoint& at, const Vec3& direction) const {
    const Real cosine = direction.dot(at.ng);
    if (cosine <= 0) return {};
    // As in sampleEmission.
    return {shape_->pdfA(at), cosine * std::numbers::inv_pi};
}

Color AreaLight::Le(const SurfacePoint& on, const Vec3& wo) const {
    if (wo.dot(on.ng) <= 0) return Color::Zero();
    return radiance_->at(on);
}

// PBR, 4th ed., 12.4.
Color AreaLight::power() const { return std::numbers::pi * area_ * radiance_->mean(); }

}  // namespace caustic
