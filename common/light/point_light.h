#pragma once

#include "light/light.h"

namespace caustic {

/// Light from one point, the same into all directions.
class PointLight final : public Light {
public:
    /// @param intensity  W/sr
    /// @throws InputError unless the position is finite and the intensity finite and at least 0
    PointLight(const Vec3& position, const Color& intensity);

    bool deltaPlace() const override { return true; }
    std::optional<DirectSample> sampleDirect(const SurfacePoint& from, const Vec2& u) const override;
    std::optional<EmissionSample> sampleEmission(const Vec2& uPlace, const Vec2& uDirection) const override;
    EmissionPdf pdfEmission(const SurfacePoint& at, const Vec3& direction) const override;
    Color power() const override;

private:
    Vec3 position_;
    Color intensity_;
};

}  // namespace caustic
