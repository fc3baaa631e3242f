#pragma once

#include <algorithm>
#include <cmath>

#include "light/light.h"
#include "material/bsdf_buffer.h"
#include "math/hit.h"
#include "math/spawn.h"
#include "medium/medium_stack.h"

namespace caustic {

/// A vertex of a path: a point of a surface, or a point of a medium at which light is scattered. A value: paths keep
/// them.
///
/// Whatever connects vertices, to lights, to the camera or to each other, needs to know no more than this: how light is
/// scattered there, by which cosine, and how to leave.
class Interaction {
public:
    /// A point of a surface.
    /// @param hit       where
    /// @param wo        unit direction to where the path came from
    /// @param light     the light that the surface is; null for none
    /// @param crossing  what the path is in on wo's side, and on the other one
    Interaction(const Hit& hit, const Vec3& wo, const Light* light, const Crossing& crossing)
        : hit_(hit), wo_(wo), light_(light), crossing_(crossing) {}

    /// A point of a medium.
    /// @param point  where
    /// @param wo     unit direction to where the path came from
    /// @param phase  the medium's, kept by reference
    /// @param media  what the path is in
    Interaction(const Vec3& point, const Vec3& wo, const PhaseFunction& phase, const MediumStack& media)
        : wo_(wo), phase_(&phase), light_(nullptr), crossing_{media, media} {
        hit_.point = point;
        // No normal and no magnitude: rays leave from the very point.
        hit_.ng = Vec3::Zero();
        hit_.ns = Vec3::Zero();
    }

    /// Whether it is a point of a surface, not of a medium.
    bool isSurface() const { return phase_ == nullptr; }

    /// Where.
    const Vec3& point() const { return hit_.point; }
    /// Where, as lights and shadow rays want to know it. A point of a medium has neither normal nor magnitude: both 0.
    const SurfacePoint& place() const { return hit_; }
    /// The hit of a surface.
    const Hit& hit() const { return hit_; }
    /// Unit direction to where the path came from.
    const Vec3& wo() const { return wo_; }

    /// How the surface scatters; null when it doesn't, and in a medium.
    const Bsdf* bsdf() const { return bsdf_.get(); }
    /// How the medium scatters; null on a surface.
    const PhaseFunction* phase() const { return phase_; }
    /// The light that the surface is; null for none.
    const Light* light() const { return light_; }
    /// Radiance that it sends along wo, W/(m²·sr).
    Color Le() const { return light_ != nullptr ? light_->Le(hit_, wo_) : Color::Zero(); }

    /// Whether a path can go on from here: always in a medium, and from a surface that has a BSDF. What follows is for
    /// those only.
    bool scatters() const { return phase_ != nullptr || bsdf_.get() != nullptr; }

    /// Whether light is scattered into more than single directions, so that the vertex can be connected to another one:
    /// in a medium, and by a BSDF with a non-specular lobe.
    bool connectible() const {
        if (phase_ != nullptr) return true;
        return bsdf_.get() != nullptr && anyOf(bsdf_.get()->lobes(), LobeFlags::Diffuse | LobeFlags::Glossy);
    }

    /// BSDF or phase function between wo and wi, without the cosine, 1/sr.
    Color f(const Vec3& wi, TransportMode mode) const {
        if (phase_ != nullptr) return Color::Constant(phase_->p(wo_, wi));
        return bsdf_.get()->f(wo_, wi, mode);
    }

    /// What f is multiplied by: |cosine| between wi and the shading normal, 1 in a medium.
    Real cosine(const Vec3& wi) const { return phase_ != nullptr ? 1 : bsdf_.get()->cosine(wi); }

    /// Samples where the path goes on to, as Bsdf::sample does. In a medium f is the phase function, and the sample has
    /// no lobes.
    std::optional<BsdfSample> sample(const Vec2& u, Real uLobe, TransportMode mode) const {
        if (phase_ == nullptr) return bsdf_.get()->sample(wo_, u, uLobe, mode);
        const PhaseSample one = phase_->sample(wo_, u);
        return BsdfSample{one.wi, Color::Constant(one.p), one.pdfW, 1, LobeFlags::None};
    }

    /// Density over solid angle with which sample picks wi, 1/sr.
    Real pdfW(const Vec3& wi) const { return phase_ != nullptr ? phase_->pdfW(wo_, wi) : bsdf_.get()->pdfW(wo_, wi); }

    /// The same the other way round: that of wo, had the path come from wi.
    Real reversePdfW(const Vec3& wi) const {
        return phase_ != nullptr ? phase_->pdfW(wi, wo_) : bsdf_.get()->pdfW(wi, wo_);
    }

    /// What turns a density over solid angle, seen from a place at distance 1 along the direction, into one over area:
    /// |cosine| between it and ng; 1 in a medium, where the density is over volume. Never 0: of two densities that
    /// vanish alike there is still a ratio.
    Real geometricCosine(const Vec3& direction) const {
        return phase_ != nullptr ? 1 : std::max(std::abs(direction.dot(hit_.ng)), Real(1e-60));
    }

    /// A ray that leaves along wi.
    Ray spawn(const Vec3& wi) const { return spawnRay(hit_, wi); }
    /// A ray to a point in free space, which it reaches at tMax = 1.
    Ray spawnTo(const Vec3& to) const { return spawnRayTo(hit_, to); }
    /// A ray to another vertex, which it reaches at tMax = 1.
    Ray spawnTo(const Interaction& to) const { return spawnRayTo(hit_, to.hit_); }

    /// What the path is in when it goes on along a direction: on wo's side as before, or across the boundary.
    const MediumStack& media(const Vec3& direction) const {
        const bool crosses = (direction.dot(hit_.ng) >= 0) != (wo_.dot(hit_.ng) >= 0);
        return crosses ? crossing_.after : crossing_.before;
    }

private:
    friend class Scene;

    Hit hit_;
    Vec3 wo_;
    const PhaseFunction* phase_ = nullptr;
    const Light* light_;
    Crossing crossing_;
    BsdfBuffer bsdf_;
};

}  // namespace caustic
