#pragma once

#include <array>
#include <span>
#include <type_traits>
#include <vector>

#include "accel/wide_real.h"
#include "mesh/mesh_data.h"
#include "shape/watertight.h"
#include "shape/watertight_error.h"

namespace caustic {

/// Eight triangles whose corners lie side by side.
/// @tparam Stored  Real, or float for a mesh whose coordinates all are floats: half as large, and exact as well
template <typename Stored>
struct alignas(64) TriangleBlock {
    using Lanes = std::conditional_t<std::is_same_v<Stored, float>, WideFloat, WideReal>;

    /// As many triangles as one instruction works on: corner by corner, axis by axis. NaN where there is no triangle.
    struct Part {
        std::array<std::array<Lanes, 3>, 3> corners;
    };

    std::array<Part, 8 / wideRealLanes> parts;  ///< the eight, in as many parts as the processor needs
    std::array<std::uint32_t, 8> triangle;      ///< the mesh's numbers of them
};

/// Makes blocks of the triangles that a tree put together.
/// @param items  eight for each block; beyond `triangles` where there are less
/// @param triangles  the mesh's number for each item
template <typename Stored>
std::vector<TriangleBlock<Stored>> makeTriangleBlocks(const MeshData& mesh, std::span<const std::uint32_t> items,
                                                      std::span<const std::uint32_t> triangles);

/// A ShearedRay in all lanes.
struct WideShearedRay {
    explicit WideShearedRay(const ShearedRay& ray);

    std::array<WideReal, 3> origin;   ///< along the ray's own axes
    std::array<WideReal, 3> shear;    ///< likewise
    WideReal tMin;                    ///< where the ray begins
    std::array<std::size_t, 3> axis;  ///< which of the world's axes each of them is
};

/// What a ray meets of some triangles.
struct WideHits {
    unsigned hit = 0;     ///< lanes of the triangles that it hits
    unsigned unsure = 0;  ///< lanes whose signs or whose t rounding may have changed: intersectWatertight decides
    WideReal t;           ///< these four say where, in the lanes of `hit`
    WideReal v;
    WideReal w;
    WideReal determinant;

    /// The hit in one of those lanes.
    TriangleHit at(unsigned lane) const { return {t[lane], v[lane] / determinant[lane], w[lane] / determinant[lane]}; }
};

inline WideShearedRay::WideShearedRay(const ShearedRay& ray) : tMin(inAllLanes(ray.ray.tMin)) {
    for (std::size_t i = 0; i < 3; ++i) {
        axis[i] = static_cast<std::size_t>(ray.axis[i]);
        origin[i] = inAllLanes(ray.ray.origin[ray.axis[i]]);
        shear[i] = inAllLanes(ray.shear[static_cast<int>(i)]);
    }
}

/// intersectWatertight of chapter 02 for many triangles at once. It does the same operations in the same order, so it
/// finds the same numbers. What is done there when these don't settle the matter isn't done here: such triangles are
/// named instead.
template <typename Part>
[[gnu::always_inline]] inline WideHits intersectWatertight(const Part& part, const WideShearedRay& ray, Real tMax) {
    const auto [i, j, k] = ray.axis;
    const auto& [a, b, c] = part.corners;
    const WideReal az = widened(a[k]) - ray.origin[2];
    const WideReal bz = widened(b[k]) - ray.origin[2];
    const WideReal cz = widened(c[k]) - ray.origin[2];
    const WideReal ax = widened(a[i]) - ray.origin[0] - ray.shear[0] * az;
    const WideReal ay = widened(a[j]) - ray.origin[1] - ray.shear[1] * az;
    const WideReal bx = widened(b[i]) - ray.origin[0] - ray.shear[0] * bz;
    const WideReal by = widened(b[j]) - ray.origin[1] - ray.shear[1] * bz;
    const WideReal cx = widened(c[i]) - ray.origin[0] - ray.shear[0] * cz;
    const WideReal cy = widened(c[j]) - ray.origin[1] - ray.shear[1] * cz;

    const WideReal u = cx * by - cy * bx;
    const WideReal v = ax * cy - ay * cx;
    const WideReal w = bx * ay - by * ax;
    const WideReal least = smaller(smaller(u, v), w);
    const WideReal most = larger(larger(u, v), w);
    WideHits found;
    const WideMask within = (least >= 0) | (most <= 0);
    const unsigned inside = lanesOf(within);
    if (inside == 0) return found;

    const auto largest = [](WideReal p, WideReal q, WideReal r) {
        return larger(larger(magnitude(p), magnitude(q)), magnitude(r));
    };
    const WideReal numerator = u * az + v * bz + w * cz;
    const WideReal error = watertightError(largest(ax, bx, cx), largest(ay, by, cy), largest(az, bz, cz),
                                           larger(magnitude(least), magnitude(most)));
    const WideMask certain = ((least > 0) | (most < 0)) & (magnitude(numerator) > error);
    const unsigned sure = lanesOf(certain);
    found.unsure = inside & ~sure;
    found.determinant = u + v + w;
    found.t = ray.shear[2] * numerator / found.determinant;
    found.v = v;
    found.w = w;
    const WideMask near = (found.t > ray.tMin) & (found.t < inAllLanes(tMax));
    found.hit = inside & sure & lanesOf(near);
    return found;
}

}  // namespace caustic
