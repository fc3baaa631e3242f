#pragma once

#include <algorithm>

#include "integrator/path_density.h"
#include "scene/interaction.h"

namespace caustic {

/// The PathDensity of a walk, kept up from vertex to vertex.
class DensityWalk {
public:
    /// @param first    at the first vertex
    /// @param left     how the walk sets out from it
    /// @param from     where it is; nothing for infinity
    /// @param cosFrom  |cosine| between the first segment and ng there; 1 for a point in space and for infinity
    DensityWalk(const PathDensity& first, const VertexPdf& left, const std::optional<Vec3>& from, Real cosFrom)
        : density_(first), left_(left), from_(from), cosFrom_(cosFrom) {}

    /// The walk reaches a vertex.
    void reach(const Interaction& at) {
        // Surfaces in contact: the walk may get from one to the other without leaving the point.
        const Real squared = from_ ? std::max((at.point() - *from_).squaredNorm(), Real(1e-60)) : 1;
        density_ = density_.next(left_, {cosFrom_, at.geometricCosine(at.wo()), squared});
    }

    /// It leaves the scene: its next vertex is at infinity.
    void escape() { density_ = density_.next(left_, {cosFrom_, 1, 1}); }

    /// It goes on from a vertex.
    void scatter(const Interaction& at, const BsdfSample& sample) {
        left_ = {1, 1, false};
        if (!sample.delta()) left_ = {sample.pdfW, at.reversePdfW(sample.wi), true};
        from_ = at.point();
        cosFrom_ = at.geometricCosine(sample.wi);
    }

    /// At the last vertex.
    const PathDensity& density() const { return density_; }

private:
    PathDensity density_;
    VertexPdf left_;
    std::optional<Vec3> from_;
    Real cosFrom_;
};

}  // namespace caustic
