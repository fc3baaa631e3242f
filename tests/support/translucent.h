#pragma once

#include <cmath>
#include <numbers>

#include "material/material.h"
#include "sampling/warp.h"

namespace caustic::test {

/// Paper: light is spread evenly over both sides, by a colour for each.
class TranslucentBsdf final : public Bsdf {
public:
    /// @param through  share that is spread over the other side; with `back` at most 1
    /// @param back     share that is spread over wo's side
    TranslucentBsdf(const ShadingFrame& shading, const Color& through, const Color& back)
        : Bsdf(shading), through_(through), back_(back) {}

    LobeFlags lobes() const override { return LobeFlags::Diffuse | LobeFlags::Reflection | LobeFlags::Transmission; }

private:
    Color localF(const Vec3&, const Vec3& wi, Real) const override {
        return (wi.z() > 0 ? back_ : through_) / std::numbers::pi;
    }
    Real localPdfW(const Vec3&, const Vec3& wi, Real) const override {
        return std::abs(wi.z()) / (2 * std::numbers::pi);
    }
    std::optional<BsdfSample> localSample(const Vec3& wo, const Vec2& u, Real uLobe, Real eta) const override {
        Vec3 wi = cosineHemisphere(u);
        if (uLobe < 0.5) wi.z() = -wi.z();
        if (wi.z() == 0) return std::nullopt;
        const LobeFlags side = wi.z() > 0 ? LobeFlags::Reflection : LobeFlags::Transmission;
        return BsdfSample{wi, localF(wo, wi, eta), localPdfW(wo, wi, eta), wi.z() > 0 ? 1 : eta,
                          LobeFlags::Diffuse | side};
    }

    Color through_;
    Color back_;
};

/// The same everywhere on a surface.
class TranslucentMaterial final : public Material {
public:
    /// As of TranslucentBsdf.
    TranslucentMaterial(const Color& through, const Color& back) : through_(through), back_(back) {}

    void build(const Hit&, const ShadingFrame& shading, BsdfBuffer& bsdf) const override {
        bsdf.emplace<TranslucentBsdf>(shading, through_, back_);
    }
    LobeFlags lobes() const override { return LobeFlags::Diffuse | LobeFlags::Reflection | LobeFlags::Transmission; }

private:
    Color through_;
    Color back_;
};

}  // namespace caustic::test
