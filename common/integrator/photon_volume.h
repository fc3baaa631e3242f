#pragma once

#include <span>
#include <vector>

#include "accel/point_beam_tree.h"
#include "integrator/photon.h"
#include "scene/scene.h"

namespace caustic {

/// Which photons of a volume count along a ray.
struct BeamSettings {
    Real radius = 0;       ///< photons farther from the ray don't count, m; greater than 0
    int mostSegments = 0;  ///< of the eye's path and the photon's together
    int eyeSegments = 1;   ///< of the eye's path, the one along which is gathered included
    bool direct = true;    ///< whether photons count that come straight from a lamp
};

/// A kernel that spreads a photon over the disc of a radius around the ray: 3 (1 − d²/R²)² / (π R²), 1/m². It is
/// smooth, and its integral over the disc is 1. Source: Silverman 1986, Density Estimation for Statistics and Data
/// Analysis, eq. 4.5.
/// @param squaredDistance  d² from the ray, m², at most R²
/// @param radius           R, m
Real beamKernel(Real squaredDistance, Real radius);

/// Photons that lie in media, in a tree: a whole ray gathers the light that they scatter to its origin, at once and
/// without steps. Never changes once it is made, so any number of threads may use it.
/// Source: Jarosz, Zwicker, Jensen 2008, The Beam Radiance Estimate for Volumetric Photon Mapping, Computer Graphics
/// Forum 27(2).
class PhotonVolume {
public:
    /// @throws InputError as PointBeamTree does
    explicit PhotonVolume(std::span<const Photon> photons);

    /// Radiance that the photons around a piece of a ray scatter to where it begins, W/(m²·sr).
    Color radiance(const MediumSpan& span, const BeamSettings& settings) const;

private:
    PointBeamTree tree_;
    std::vector<Photon> photons_;  // in the tree's order
};

}  // namespace caustic
