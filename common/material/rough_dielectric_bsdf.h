#pragma once

#include "material/bsdf.h"
#include "material/ggx.h"

namespace caustic {

/// Ground glass: facets that are DielectricBsdf each. Light that meets a second facet is lost, the more the rougher.
/// Source: Walter 2007.
class RoughDielectricBsdf final : public Bsdf {
public:
    /// The indices are those of the shading frame. They have to differ: light that isn't bent tells nothing of facets.
    /// @param facets  in the shading frame, the same seen from below
    RoughDielectricBsdf(const ShadingFrame& shading, const Ggx& facets) : Bsdf(shading), facets_(facets) {}

    LobeFlags lobes() const override { return LobeFlags::Glossy | LobeFlags::Reflection | LobeFlags::Transmission; }

private:
    // What a pair of directions is worth, given the facets that bring one into the other.
    struct Value {
        Real f = 0;
        Real pdfW = 0;
    };
    Color localF(const Vec3& wo, const Vec3& wi, Real eta) const override;
    Real localPdfW(const Vec3& wo, const Vec3& wi, Real eta) const override;
    std::optional<BsdfSample> localSample(const Vec3& wo, const Vec2& u, Real uLobe, Real eta) const override;
    Value value(const Vec3& wo, const Vec3& wi, Real eta) const;

    Ggx facets_;
};

}  // namespace caustic
