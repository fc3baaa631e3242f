#pragma once

#include "light/light.h"
#include "material/bsdf_buffer.h"
#include "math/hit.h"
#include "medium/medium_stack.h"

namespace caustic {

/// A hit as light sees it. A value: paths keep them.
class Interaction {
public:
    /// @param hit       where
    /// @param wo        unit direction to where the path came from
    /// @param light     the light that the surface is; null for none
    /// @param crossing  what the path is in on wo's side, and on the other one
    Interaction(const Hit& hit, const Vec3& wo, const Light* light, const Crossing& crossing)
        : hit_(hit), wo_(wo), light_(light), crossing_(crossing) {}

    /// Where.
    const Hit& hit() const { return hit_; }
    /// Unit direction to where the path came from.
    const Vec3& wo() const { return wo_; }

    /// How the surface scatters; null when it doesn't.
    const Bsdf* bsdf() const { return bsdf_.get(); }
    /// The light that the surface is; null for none.
    const Light* light() const { return light_; }
    /// Radiance that it sends along wo, W/(m²·sr).
    Color Le() const { return light_ != nullptr ? light_->Le(hit_, wo_) : Color::Zero(); }

    /// What the path is in when it goes on along a direction: on wo's side as before, or across the boundary.
    const MediumStack& media(const Vec3& direction) const {
        const bool crosses = (direction.dot(hit_.ng) >= 0) != (wo_.dot(hit_.ng) >= 0);
        return crosses ? crossing_.after : crossing_.before;
    }

private:
    friend class Scene;

    Hit hit_;
    Vec3 wo_;
    const Light* light_;
    Crossing crossing_;
    BsdfBuffer bsdf_;
};

}  // namespace caustic
