#pragma once

#include "material/bsdf.h"
#include "material/ggx.h"
#include "material/metal.h"

namespace caustic {

/// A rough metal: facets that are ConductorBsdf each, f = F D G / (4 cosO cosI) with F for the angle between wo and
/// the facets half-way between wo and wi; 0 unless wo and wi are both above the surface. Light that meets a second
/// facet is lost, the more the rougher. Source: Cook, Torrance 1982; Walter 2007, eq. 20.
class RoughConductorBsdf final : public Bsdf {
public:
    /// @param metal   its index over that of what lies above it
    /// @param facets  in the shading frame
    RoughConductorBsdf(const ShadingFrame& shading, const Metal& metal, const Ggx& facets)
        : Bsdf(shading), metal_(metal), facets_(facets) {}

    LobeFlags lobes() const override { return LobeFlags::Glossy | LobeFlags::Reflection; }

private:
    Color localF(const Vec3& wo, const Vec3& wi, Real eta) const override;
    Real localPdfW(const Vec3& wo, const Vec3& wi, Real eta) const override;
    std::optional<BsdfSample> localSample(const Vec3& wo, const Vec2& u, Real uLobe, Real eta) const override;

    Metal metal_;
    Ggx facets_;
};

}  // namespace caustic
