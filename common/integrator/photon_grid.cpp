#include "integrator/photon_grid.h"

#include "core/not_implemented.h"

namespace caustic {

PhotonGrid::PhotonGrid(std::span<const Photon> photons, Real radius) : grid_(pointsOf(photons), 2 * radius) {
    photons_.reserve(photons.size());
    for (const std::uint32_t i : grid_.order()) photons_.push_back(photons[i]);
}

Gathered PhotonGrid::gather(const VisiblePoint& point, Real radius, int mostSegments) const {
    //! [ex-09.6]
    Gathered found;
    const Interaction& at = point.at;
    grid_.within(at.point(), radius, [&](const NearPoint& near) {
        const Photon& photon = photons_[near.place];
        if (point.length + photon.length > mostSegments) return;
        // A photon that comes from behind lit the other side: f is 0, and it doesn't count.
        const Color f = at.f(photon.wi, TransportMode::Radiance);
        if ((f == 0).all()) return;
        // Photons are as dense as the geometry says, light is scattered by the shading normal's cosine.
        found.flux += f * photon.power * (at.cosine(photon.wi) / at.geometricCosine(photon.wi));
        ++found.photons;
    });
    return found;
    //! [ex-09.6]
}

}  // namespace caustic
