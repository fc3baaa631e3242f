#pragma once

#include <numbers>

#include "material/directions.h"
#include "material/material.h"
#include "sampling/warp.h"

namespace caustic::test {

/// A colour under varnish: a delta lobe mirrors a share of the light, and what is below spreads another one. Of ten
/// samples three are mirrored, six are spread, and one is none.
class VarnishBsdf final : public Bsdf {
public:
    /// @param mirrored  share of the light that is mirrored; with `spread` at most 1
    VarnishBsdf(const ShadingFrame& shading, const Color& mirrored, const Color& spread)
        : Bsdf(shading), mirrored_(mirrored), spread_(spread) {}

    LobeFlags lobes() const override { return LobeFlags::Delta | LobeFlags::Diffuse | LobeFlags::Reflection; }

private:
    Color localF(const Vec3&, const Vec3& wi, Real) const override {
        return wi.z() > 0 ? Color(spread_ / std::numbers::pi) : Color::Zero();
    }
    Real localPdfW(const Vec3&, const Vec3& wi, Real) const override {
        return wi.z() > 0 ? 0.6 * wi.z() / std::numbers::pi : 0;
    }
    std::optional<BsdfSample> localSample(const Vec3& wo, const Vec2& u, Real uLobe, Real eta) const override {
        if (uLobe < 0.3) return localDeltaLobes(wo, eta).lobe[0];
        if (uLobe >= 0.9) return std::nullopt;
        const Vec3 wi = cosineHemisphere(u);
        return BsdfSample{wi, localF(wo, wi, eta), localPdfW(wo, wi, eta), 1,
                          LobeFlags::Diffuse | LobeFlags::Reflection};
    }
    DeltaLobes localDeltaLobes(const Vec3& wo, Real) const override {
        DeltaLobes all;
        all.add({reflected(wo, Vec3::UnitZ()), mirrored_, 0.3, 1, LobeFlags::Delta | LobeFlags::Reflection});
        return all;
    }

    Color mirrored_;
    Color spread_;
};

/// The same everywhere on a surface.
class VarnishMaterial final : public Material {
public:
    /// As of VarnishBsdf.
    VarnishMaterial(const Color& mirrored, const Color& spread) : mirrored_(mirrored), spread_(spread) {}

    void build(const Hit&, const ShadingFrame& shading, BsdfBuffer& bsdf) const override {
        bsdf.emplace<VarnishBsdf>(shading, mirrored_, spread_);
    }
    LobeFlags lobes() const override { return LobeFlags::Delta | LobeFlags::Diffuse | LobeFlags::Reflection; }

private:
    Color mirrored_;
    Color spread_;
};

}  // namespace caustic::test
