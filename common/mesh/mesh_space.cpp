#include "mesh/mesh_space.h"

#include <cmath>

namespace caustic {

namespace {

// A watertight test displaces a ray by less than 8 unit roundoffs of the distance: from 2²⁰ sizes away, 2⁻³⁰.
constexpr Real boxMargin = 0x1p-30;

}  // namespace

MeshSpace::MeshSpace(const Bounds3& box) : center_((box.min() + box.max()) / 2) {
    const Real half = (box.max() - center_).cwiseAbs().cwiseMax((box.min() - center_).cwiseAbs()).maxCoeff();
    scale_ = half > 0 ? std::exp2(-std::ceil(std::log2(half))) : 1;
    const Vec3 margin = Vec3::Constant(boxMargin);
    box_ = {toTree(box.min()) - margin, toTree(box.max()) + margin};
}

}  // namespace caustic
