#pragma once

#include <array>
#include <cmath>
#include <optional>

#include "material/lobe_flags.h"
#include "material/shading_frame.h"
#include "math/color.h"

namespace caustic {

/// What a path carries, which decides how a surface changes it.
enum class TransportMode {
    /// Radiance, on a path from the eye. What comes through a boundary from n_i to n_o is scaled by (n_o/n_i)² =
    /// 1/eta², since its solid angle changes. Source: Veach 5.2.
    Radiance,
    /// Importance, on a path from a light. No such scale, but the factor that makes shading normals mean the same for
    /// both kinds of path. Source: Veach 5.3.2.
    Importance
};

/// Result of Bsdf::sample. Directions are unit length, world space, and point away from the surface.
struct BsdfSample {
    Vec3 wi = Vec3::UnitZ();            ///< sampled direction
    Color f = Color::Zero();            ///< BSDF value, 1/sr, cosine not included; for a delta lobe the integrated
                                        ///< weight, unitless, that multiplies what comes in
    Real pdfW = 0;                      ///< density over solid angle, 1/sr; for a delta lobe the lobe's probability
    Real eta = 1;                       ///< relative index of refraction along wi, n_i/n_o; 1 for a reflection
    LobeFlags lobes = LobeFlags::None;  ///< which lobe was sampled

    /// Whether the direction was the only one possible.
    bool delta() const { return anyOf(lobes, LobeFlags::Delta); }
    /// Whether the path goes to the other side.
    bool transmits() const { return anyOf(lobes, LobeFlags::Transmission); }
};

/// The delta lobes of a BSDF: a smooth boundary reflects and transmits, a mirror only reflects.
struct DeltaLobes {
    std::array<BsdfSample, 2> lobe;  ///< each with its probability in pdfW
    int count = 0;                   ///< how many there are

    /// Appends one.
    void add(const BsdfSample& one) { lobe[static_cast<std::size_t>(count++)] = one; }
    /// For range-based loops over those that are there.
    const BsdfSample* begin() const { return lobe.data(); }
    /// The same.
    const BsdfSample* end() const { return lobe.data() + count; }
};

/// How a surface scatters light at one point.
///
/// Reciprocal (f(wo, wi) = f(wi, wo) for reflection, modes aside) and energy conserving (∫ f |cos| dω ≤ 1 for every
/// wo). Models live in the shading frame, seen from wo's side: a model's z axis is ns, or −ns when wo is below the
/// surface. Which side a direction is on, ng decides. Nothing is scattered that comes from a direction about whose
/// side ng and ns disagree; into such a direction light is scattered, or smooth meshes would be black at their
/// outlines. Source: Veach 1997, ch. 5. Tests: tests/05_ray_tracing/property_bsdf.cpp.
class Bsdf {
public:
    virtual ~Bsdf() = default;

    /// Value without the cosine, 1/sr; delta lobes not included.
    Color f(const Vec3& wo, const Vec3& wi, TransportMode mode) const;

    /// Samples wi about in proportion to f |cos|.
    /// @param wo     unit direction to where the path came from
    /// @param u      two uniform numbers in [0, 1)
    /// @param uLobe  another one: chooses the lobe
    /// @return nothing when the sample leaves the model's domain; never a zero pdf. f may be 0, where the normals
    /// disagree.
    std::optional<BsdfSample> sample(const Vec3& wo, const Vec2& u, Real uLobe, TransportMode mode) const;

    /// Density over solid angle with which sample picks wi, 1/sr; delta lobes not included. Swap the two for the
    /// reverse.
    Real pdfW(const Vec3& wo, const Vec3& wi) const;

    /// All delta lobes, for an integrator that follows each of them instead of sampling one.
    DeltaLobes deltaLobes(const Vec3& wo, TransportMode mode) const;

    /// What its lobes do.
    virtual LobeFlags lobes() const = 0;

    /// |cosine| between wi and the shading normal: what f is multiplied by.
    Real cosine(const Vec3& wi) const { return std::abs(wi.dot(shading_.frame.n)); }

protected:
    /// Remembers where the surface stands.
    explicit Bsdf(const ShadingFrame& shading) : shading_(shading) {}
    /// A model may be copied, by BsdfBuffer alone.
    Bsdf(const Bsdf&) = default;
    Bsdf& operator=(const Bsdf&) = delete;

private:
    // The model in its own frame. wo.z may be a little below 0 where ng and ns disagree. Values carry energy: the base
    // class turns them into what `mode` asks for. eta is n on the other side over n on wo's side.
    virtual Color localF(const Vec3& wo, const Vec3& wi, Real eta) const = 0;
    virtual Real localPdfW(const Vec3& wo, const Vec3& wi, Real eta) const = 0;
    virtual std::optional<BsdfSample> localSample(const Vec3& wo, const Vec2& u, Real uLobe, Real eta) const = 0;
    virtual DeltaLobes localDeltaLobes(const Vec3& /*wo*/, Real /*eta*/) const { return {}; }

    std::optional<BsdfSample> deltaToWorld(const BsdfSample& local, const Vec3& wo, TransportMode mode) const;
    std::optional<BsdfSample> nonSpecularToWorld(const BsdfSample& local, const Vec3& wo, TransportMode mode) const;
    Real normalsFactor(const Vec3& wo, const Vec3& wi) const;

    ShadingFrame shading_;
};

}  // namespace caustic
