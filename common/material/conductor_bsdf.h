#pragma once

#include "material/bsdf.h"
#include "material/metal.h"

namespace caustic {

/// A polished metal: reflects what Fresnel's equations for conductors say into the mirror direction, swallows the rest.
class ConductorBsdf final : public Bsdf {
public:
    /// @param metal  its index over that of what lies above it
    ConductorBsdf(const ShadingFrame& shading, const Metal& metal) : Bsdf(shading), metal_(metal) {}

    LobeFlags lobes() const override { return LobeFlags::Delta | LobeFlags::Reflection; }

private:
    Color localF(const Vec3&, const Vec3&, Real) const override { return Color::Zero(); }
    Real localPdfW(const Vec3&, const Vec3&, Real) const override { return 0; }
    std::optional<BsdfSample> localSample(const Vec3& wo, const Vec2& u, Real uLobe, Real eta) const override;
    DeltaLobes localDeltaLobes(const Vec3& wo, Real eta) const override;

    Metal metal_;
};

}  // namespace caustic
