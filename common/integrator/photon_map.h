#pragma once

#include <optional>
#include <span>
#include <vector>

#include "accel/point_kd_tree.h"
#include "integrator/photon.h"
#include "scene/interaction.h"

namespace caustic {

/// Which photons around a point stand for the light that comes to it.
struct DensitySettings {
    /// ① So many photons, the nearest ones; at least 1. Nothing: ② all within the radius.
    std::optional<int> nearest = 50;

    /// Photons farther away never count, m; finite and greater than 0.
    Real radius = 0.1;

    /// κ of the cone filter, by which photons count less the farther away they are: 1 − d/(κ r). At least 1, or 0 for
    /// no filter. Source: Jensen 1996, 3.
    Real cone = 0;
};

/// Passes the settings on.
/// @throws InputError when one is out of its range
const DensitySettings& checkDensity(const DensitySettings& settings);

/// Photons in a tree, and the light that surfaces around them scatter: a density of power over area, estimated by the
/// photons near a point. Never changes once it is made, so any number of threads may use it.
/// Source: Jensen 1996, Global Illumination using Photon Maps, 3.
class PhotonMap {
public:
    /// @throws InputError as PointKdTree does
    explicit PhotonMap(std::span<const Photon> photons);

    /// How many photons there are.
    std::size_t size() const { return photons_.size(); }
    /// All of them, in the tree's order.
    std::span<const Photon> photons() const { return photons_; }

    /// Those that a density is estimated by.
    struct Neighbours {
        std::vector<NearPoint> photons;  ///< places in photons()
        Real squaredRadius = 0;          ///< of the disc that they stand for, m²; greater than 0
    };

    /// Finds them. The k nearest stand for a disc that reaches to the photon behind them, so that their density is
    /// right in the mean: the expected value of k/(π r²) is the density if r is the distance of photon k + 1, and with
    /// that of photon k it is larger by k/(k − 1). When no more than k are within the radius, they stand for all of it.
    ///
    /// Photons count that lie on a surface which faces the same way, within 60°, and light the side that is seen; of a
    /// surface that lets light through, both sides.
    /// @param at  a surface that is connectible()
    Neighbours neighbours(const Interaction& at, const DensitySettings& settings) const;

    /// Radiance that a surface scatters along at.wo() of the light that the photons around it stand for, W/(m²·sr).
    /// @param at  a surface that is connectible()
    Color radiance(const Interaction& at, const DensitySettings& settings) const;

private:
    PointKdTree tree_;
    std::vector<Photon> photons_;  // in the tree's order
};

}  // namespace caustic
