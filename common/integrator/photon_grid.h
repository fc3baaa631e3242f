#pragma once

#include <span>
#include <vector>

#include "accel/hash_grid.h"
#include "integrator/photon_tracer.h"
#include "integrator/radius_rule.h"
#include "integrator/visible_point.h"

namespace caustic {

/// A pass's photons in a hash grid.
class PhotonGrid {
public:
    /// @param radius  that most points ask for, m, greater than 0
    PhotonGrid(std::span<const Photon> photons, Real radius);

    /// How many photons there are.
    std::size_t size() const { return photons_.size(); }

    /// What the photons within a radius scatter from a visible point to the eye.
    /// @param radius       m
    /// @param mostSegments of the eye's path and the photon's together
    Gathered gather(const VisiblePoint& point, Real radius, int mostSegments) const;

private:
    HashGrid grid_;
    std::vector<Photon> photons_;  // in the grid's order
};

}  // namespace caustic
