#pragma once

#include "material/bsdf.h"

namespace caustic {

/// A smooth surface: scatters into single directions only, so that f and pdfW are 0 everywhere.
class DeltaBsdf : public Bsdf {
protected:
    /// Remembers where the surface stands.
    explicit DeltaBsdf(const ShadingFrame& shading) : Bsdf(shading) {}

private:
    Color localF(const Vec3&, const Vec3&, Real) const final { return Color::Zero(); }
    Real localPdfW(const Vec3&, const Vec3&, Real) const final { return 0; }

    // One of the delta lobes, each as often as its probability says.
    std::optional<BsdfSample> localSample(const Vec3& wo, const Vec2& u, Real uLobe, Real eta) const final;
    DeltaLobes localDeltaLobes(const Vec3& wo, Real eta) const override = 0;
};

}  // namespace caustic
