#pragma once

#include "math/vector.h"

namespace caustic {

/// A rough surface as a landscape of tiny flat facets, whose normals have the GGX distribution: as if an ellipsoid's
/// surface had been cut up and its pieces strewn about. Works in the shading frame: z along ns, wo and facets above it.
///
/// Facets hide each other. Smith's model takes heights and normals as independent of each other, which gives all shares
/// in closed form. Source: Trowbridge, Reitz 1975; Walter 2007; Heitz 2014, Understanding the Masking-Shadowing
/// Function in Microfacet-Based BRDFs, JCGT 3(2); PBR 9.6.
class Ggx {
public:
    /// Below this roughness a surface is taken for a smooth one: highlights are then narrower than 0.02 degrees.
    static constexpr Real smoothBelow = 1e-4;

    /// @param alphaX  roughness along the first tangent: how steep facets are there; taken for smoothBelow when less
    /// @param alphaY  the same along the second tangent
    Ggx(Real alphaX, Real alphaY);

    /// Area of the facets with this normal, per solid angle of normals and area of the surface, 1/sr. Their projections
    /// cover the surface: ∫ D(wm) wm.z dwm = 1.
    /// @param wm  unit normal; 0 unless wm.z > 0
    Real D(const Vec3& wm) const;

    /// Smith's Λ: how much of the facets that face w is hidden from it, per what is seen. 0 along the normal.
    /// @param w  unit direction, above or below the surface, which makes no difference; infinite for one along it
    Real lambda(const Vec3& w) const;

    /// Share of the facets facing w that w sees, in [0, 1]. Source: Heitz 2014, eq. 43.
    Real G1(const Vec3& w) const { return 1 / (1 + lambda(w)); }

    /// Share of the facets that both see, wo and wi on the same side, in [0, 1]: a facet high up is seen from both.
    /// Source: Heitz 2014, eq. 99.
    Real reflectionG(const Vec3& wo, const Vec3& wi) const { return 1 / (1 + lambda(wo) + lambda(wi)); }

    /// The same with wi on the other side: what is high up for one is deep down for the other. At a height that the
    /// share h of all facets lie below, h^Λ(wo) is seen from above and (1 − h)^Λ(wi) from below; the mean over all
    /// heights is Euler's B(1 + Λ(wo), 1 + Λ(wi)). Source: Heitz et al. 2016, Multiple-Scattering Microfacet BSDFs with
    /// the Smith Model, ACM Transactions on Graphics 35(4).
    Real transmissionG(const Vec3& wo, const Vec3& wi) const;

    /// Samples a normal among those that wo sees, with the density of pdfVisible.
    /// Source: Heitz 2018; this form: Dupuy, Benyoub 2023, Sampling Visible GGX Normals with Spherical Caps.
    /// @param wo  unit direction, wo.z > 0
    /// @param u   two uniform numbers in [0, 1)
    /// @return a unit normal with wm.z > 0 and, but for rounding, wo · wm ≥ 0
    Vec3 sampleVisible(const Vec3& wo, const Vec2& u) const;

    /// Density over solid angle of sampleVisible, 1/sr: G1(wo) D(wm) (wo · wm) / wo.z.
    Real pdfVisible(const Vec3& wo, const Vec3& wm) const;

    /// Samples a normal among all, seen or not, with the density D(wm) wm.z. What was usual before visible normals, and
    /// is here to compare. Source: Walter 2007, eq. 35 and 36.
    Vec3 sampleAll(const Vec2& u) const;

private:
    Real alphaX_;
    Real alphaY_;
};

}  // namespace caustic
