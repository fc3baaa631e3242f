#pragma once

#include <vector>

#include "image/image.h"
#include "modeler/diffuse_box.h"

namespace caustic {

/// What a DiffuseBox looks like, by radiosity: no random number, no ray, no BSDF, so it judges those who use them.
///
/// Each wall is cut into n × n patches. How much of its surroundings a point sees of a patch is known in closed form
/// (Lambert 1760), and in an empty box nothing is in the way. The patches' radiances solve
/// R_i = ρ_i (Σ_lamp F_il L + Σ_j F_ij R_j), by iteration; a mirror adds the same box once more, behind it.
/// Source: Goral et al. 1984, Modeling the Interaction of Light Between Diffuse Surfaces.
class BoxRadiosity {
public:
    /// @param patches  along a wall's edge, at least 1
    /// @param threads  at least 1; the result doesn't depend on it
    BoxRadiosity(const DiffuseBox& box, int patches, int threads);

    /// The picture that a camera takes.
    /// @param perAxis  this squared is the number of rays a pixel, on a regular grid
    Image picture(const Camera& camera, int perAxis, int threads) const;

private:
    struct Patch {
        Vec3 corner;
        Vec3 edgeU;
        Vec3 edgeV;
        Color reflectance;
        Color radiance;
        Real open = 1;  // share that the lamp doesn't cover
    };

    void addWall(const BoxWall& wall);
    void solve(int threads);
    Real factor(const Vec3& point, const Vec3& normal, const Patch& patch) const;
    Color gathered(const Vec3& point, const Vec3& normal) const;
    void tabulate(int threads);
    Color seen(Vec3 origin, Vec3 direction) const;
    Color tabulated(std::size_t wall, const Vec2& uv) const;

    DiffuseBox box_;
    std::vector<BoxWall> walls_;
    int perEdge_;
    Patch lamp_;
    std::vector<Patch> patches_;
    std::vector<std::vector<Color>> nodes_;  // of each wall, radiances at a grid twice as fine
};

}  // namespace caustic
