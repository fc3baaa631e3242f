#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

#include "math/ray.h"
#include "shape/triangle_hit.h"

namespace caustic {

/// What the watertight test needs of a ray, computed once for all triangles: the axes in an order that puts the
/// direction's largest component last, and the shear and scale that turn the direction into (0, 0, 1).
struct ShearedRay {
    explicit ShearedRay(const Ray& original);

    /// The ray as it was given.
    Ray ray;
    std::array<int, 3> axis;  ///< the axes that play x, y and z; a rotation or its mirror, so that windings stay
    Vec3 shear;               ///< Sx, Sy, Sz of the paper: dx/dz, dy/dz, 1/dz

private:
    // The axes in their order, given that of the direction's largest component: for a positive one, and for a negative
    // one. Looked up: a branch for each question would be guessed wrongly once a ray.
    static constexpr std::array<std::array<std::array<int, 3>, 3>, 2> axesFor = {
        {{{{1, 2, 0}, {2, 0, 1}, {0, 1, 2}}}, {{{2, 1, 0}, {0, 2, 1}, {1, 0, 2}}}}};
};

/// Ray and triangle without leaks: a ray through an edge or a vertex of a closed mesh hits at least one of the
/// triangles there, however it rounds.
///
/// Each vertex is moved into the ray's space in the same way whichever triangle it belongs to, and each edge is judged
/// by the sign of one difference of products, which its two triangles compute with swapped signs. Products round
/// monotonically, so that sign is never wrong, at worst it is zero; then the exact remainders of the products decide.
/// Whether the triangle is ahead of the ray or behind it is computed in twice the precision when rounding could have
/// changed the answer: a sliver that a ray starts on, or just inside of. Both sides of the triangle count, and no
/// triangle is too small.
/// Needs -ffp-contract=off: a fused product would break the antisymmetry.
/// Source: Woop, Benthin, Wald 2013, Watertight Ray/Triangle Intersection, JCGT 2(1); the remainders by std::fma
/// replace the paper's fall-back to double.
/// @return nothing for a miss, a t that the ray doesn't reach, or a triangle seen edge-on: one whose three numbers sum
///         to 0
std::optional<TriangleHit> intersectWatertight(const ShearedRay& sheared, const Vec3& a, const Vec3& b, const Vec3& c);

// In the header, so that what it computes stays in registers: 3 % more rays with the trees of chapter 04.
inline ShearedRay::ShearedRay(const Ray& original) : ray(original) {
    const Vec3 size = original.direction.cwiseAbs();
    const int y = size.y() > size.x() ? 1 : 0;
    const int z = size.z() > std::max(size.x(), size.y()) ? 2 : y;
    axis = axesFor[original.direction[z] < 0 ? 1 : 0][static_cast<std::size_t>(z)];
    const Real dz = original.direction[z];
    shear = {original.direction[axis[0]] / dz, original.direction[axis[1]] / dz, 1 / dz};
}

}  // namespace caustic
