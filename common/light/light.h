#pragma once

#include <optional>

#include "math/bounds.h"
#include "math/color.h"
#include "math/hit.h"
#include "math/ray.h"

namespace caustic {

/// Result of Light::sampleDirect: where a point is lit from.
struct DirectSample {
    Vec3 wi = Vec3::UnitZ();         ///< unit direction from the point to the light
    Color radiance = Color::Zero();  ///< that arrives along wi if nothing is in the way, W/(m²·sr); from a light with a
                                     ///< delta place, the irradiance of a surface that faces it, W/m²
    Real pdfW = 0;    ///< density of wi over solid angle, 1/sr; 1 for a delta place
    Ray ray;          ///< from the point to the light: whatever it meets is in the way
    SurfacePoint on;  ///< the point of the light and ng there; no normal (0) for a delta place, nothing at infinity
};

/// Result of Light::sampleEmission: light that sets out. A path that carries it has the throughput
/// radiance · |ng · direction| / (pdfA · pdfW), in W.
struct EmissionSample {
    Ray ray;                         ///< leaves the light; unit direction
    Vec3 ng = Vec3::UnitZ();         ///< unit normal where it does; along the ray for a delta place
    Color radiance = Color::Zero();  ///< W/(m²·sr); for a delta place the intensity, W/sr
    Real pdfA = 0;                   ///< density of the place over area, 1/m²; 1 for a delta place
    Real pdfW = 0;                   ///< density of the direction over solid angle, 1/sr
};

/// The two densities of an emitted ray.
struct EmissionPdf {
    Real pdfA = 0;  ///< of the place, 1/m²; 0 for a delta place
    Real pdfW = 0;  ///< of the direction, 1/sr
};

/// Something that sends out light. Never changes after prepare.
class Light {
public:
    virtual ~Light() = default;

    /// Tells the light how large the scene is, before the first ray. Lights that aren't at any place need to know.
    /// @param scene  a box around all that is bounded; empty when nothing is
    virtual void prepare(const Bounds3& scene) { static_cast<void>(scene); }

    /// Whether all of it is at one point, so that no path hits it by chance.
    virtual bool deltaPlace() const { return false; }
    /// Whether it is infinitely far away, so that rays which leave the scene find it.
    virtual bool infinite() const { return false; }

    /// Picks a direction from a point towards the light. The point of the light's surface is picked with the same
    /// density over area as by sampleEmission; so is the direction of a light that is infinitely far away.
    /// @param from  where light arrives; a point in free space has magnitude 0
    /// @param u     two uniform numbers in [0, 1)
    /// @return nothing when no light comes from there; never a zero pdf
    virtual std::optional<DirectSample> sampleDirect(const SurfacePoint& from, const Vec2& u) const = 0;

    /// Density over solid angle with which sampleDirect picks the direction from a point to a point of the light's
    /// surface, 1/sr; 0 when it has none.
    virtual Real pdfW(const Vec3& from, const SurfacePoint& on) const;

    /// The same for a direction that leaves the scene.
    virtual Real pdfW(const Vec3& from, const Vec3& wi) const;

    /// Picks light that sets out.
    /// @param uPlace      two uniform numbers in [0, 1)
    /// @param uDirection  two more
    virtual std::optional<EmissionSample> sampleEmission(const Vec2& uPlace, const Vec2& uDirection) const = 0;

    /// The densities with which sampleEmission picks a ray.
    /// @param at         where it starts, for a light with a surface
    /// @param direction  unit direction that it goes to
    virtual EmissionPdf pdfEmission(const SurfacePoint& at, const Vec3& direction) const = 0;

    /// Radiance that a point of the light's surface sends along wo, W/(m²·sr); 0 for a light without one.
    virtual Color Le(const SurfacePoint& on, const Vec3& wo) const;

    /// Radiance that arrives along a ray which has left the scene, W/(m²·sr).
    virtual Color Le(const Ray& escaped) const;

    /// All of it, in W.
    virtual Color power() const = 0;
};

}  // namespace caustic
