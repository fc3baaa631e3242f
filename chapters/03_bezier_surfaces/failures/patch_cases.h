#pragma once

#include <string>
#include <vector>

#include "core/random.h"
#include "surface/newton.h"
#include "surface/patch_surface.h"

namespace caustic {

/// A patch for the report's Newton method.
class ParametricPatch final : public ParametricSurface {
public:
    /// The patch must live as long.
    explicit ParametricPatch(const BezierPatch& patch) : patch_(patch) {}

    SurfaceJet evaluate(Real u, Real v) const override { return patch_.evaluate(u, v); }
    bool closedInV() const override { return false; }

private:
    const BezierPatch& patch_;
};

/// Patches that hold every difficulty: bicubic waves, a saddle, a collapsed edge, a fold, a cusp, degrees 5 × 4 and 9
/// × 9.
std::vector<BezierPatch> difficultPatches();

/// A family of rays at a patch.
struct PatchRaySet {
    std::string name;
    Ray (*make)(const PatchSurface& surface, Random& random);
};

/// Random chords first, then the adversarial sets.
std::vector<PatchRaySet> patchRaySets();

}  // namespace caustic
