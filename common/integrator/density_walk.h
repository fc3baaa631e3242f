#pragma once

#include <algorithm>
#include <cmath>

#include "integrator/path_density.h"
#include "scene/interaction.h"

namespace caustic {

/// |cosine| between a direction and ng, never 0: two densities that vanish alike still have a ratio.
inline Real geometricCosine(const Hit& hit, const Vec3& direction) {
    return std::max(std::abs(direction.dot(hit.ng)), Real(1e-60));
}

/// The PathDensity of a walk, kept up from vertex to vertex.
class DensityWalk {
public:
    /// @param first    density of the first vertex
    /// @param pdf      how the walk sets out from it
    /// @param from     where it is; nothing for infinity
    /// @param cosFrom  |cosine| between the first segment and ng there; 1 for a point in space and for infinity
    DensityWalk(const PathDensity& first, const ScatteringPdf& pdf, const std::optional<Vec3>& from, Real cosFrom)
        : density_(first), pdf_(pdf), from_(from), cosFrom_(cosFrom) {}

    /// The walk reaches a surface.
    void reach(const Interaction& at) {
        // Surfaces in contact: the walk may get from one to the other without leaving the point.
        const Real squared = from_ ? std::max((at.hit().point - *from_).squaredNorm(), Real(1e-60)) : 1;
        density_ = density_.next(pdf_, {cosFrom_, geometricCosine(at.hit(), at.wo()), squared});
    }

    /// It leaves the scene: its next vertex is at infinity.
    void escape() { density_ = density_.next(pdf_, {cosFrom_, 1, 1}); }

    /// It goes on from a surface.
    void scatter(const Interaction& at, const BsdfSample& sample) {
        pdf_ = {1, 1, true};
        if (!sample.delta()) pdf_ = {sample.pdfW, at.bsdf()->pdfW(sample.wi, at.wo()), false};
        from_ = at.hit().point;
        cosFrom_ = geometricCosine(at.hit(), sample.wi);
    }

    /// At the last vertex.
    const PathDensity& density() const { return density_; }

private:
    PathDensity density_;
    ScatteringPdf pdf_;
    std::optional<Vec3> from_;
    Real cosFrom_;
};

}  // namespace caustic
