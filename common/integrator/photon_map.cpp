#include "integrator/photon_map.h"

#include <cmath>
#include <numbers>

#include "core/check.h"
#include "core/not_implemented.h"

namespace caustic {

namespace {

constexpr Real mostTurned = 0.5;  // cosine between the normals of two places of one surface

// Whether the photon is on the same surface, as far as normals tell, and on the side that is seen: photons of a wall
// that stands on a floor say nothing of the floor.
bool lights(const Photon& photon, const Interaction& at) {
    const Vec3& ng = at.hit().ng;
    if (photon.ng.dot(ng) < mostTurned) return false;
    if (anyOf(at.bsdf()->lobes(), LobeFlags::Transmission)) return true;
    return (photon.wi.dot(ng) >= 0) == (at.wo().dot(ng) >= 0);
}

}  // namespace

const DensitySettings& checkDensity(const DensitySettings& settings) {
    if (settings.nearest) {
        checkArgument(*settings.nearest >= 1, "nearest photons", std::to_string(*settings.nearest),
                      "must be at least 1");
    }
    checkPositive(settings.radius, "radius of photons");
    checkArgument(settings.cone == 0 || (std::isfinite(settings.cone) && settings.cone >= 1), "cone filter",
                  formatReal(settings.cone), "must be at least 1, or 0 for none");
    return settings;
}

PhotonMap::PhotonMap(std::span<const Photon> photons) : tree_(pointsOf(photons)) {
    photons_.reserve(photons.size());
    for (const std::uint32_t i : tree_.order()) photons_.push_back(photons[i]);
}

PhotonMap::Neighbours PhotonMap::neighbours(const Interaction& at, const DensitySettings& settings) const {
    //! [ex-08.6]
    Neighbours found = {{}, settings.radius * settings.radius};
    const auto counts = [&](std::uint32_t place) { return lights(photons_[place], at); };
    if (!settings.nearest) {
        tree_.within(at.point(), settings.radius, [&](const NearPoint& near) {
            if (counts(near.place)) found.photons.push_back(near);
        });
        return found;
    }
    const auto k = static_cast<std::size_t>(*settings.nearest);
    NearestPoints nearest;
    tree_.nearest(at.point(), k + 1, settings.radius, nearest, counts);
    auto points = nearest.points();
    if (nearest.full() && points.front().squaredDistance > 0) {
        found.squaredRadius = points.front().squaredDistance;
        points = points.subspan(1);
    }
    found.photons.assign(points.begin(), points.end());
    return found;
    //! [ex-08.6]
}

Color PhotonMap::radiance(const Interaction& at, const DensitySettings& settings) const {
    //! [ex-08.7]
    const Neighbours near = neighbours(at, settings);
    Color sum = Color::Zero();
    for (const NearPoint& one : near.photons) {
        const Photon& photon = photons_[one.place];
        // Photons lie as dense as the geometry says; light is scattered by the shading normal's cosine.
        const Real cosines = at.cosine(photon.wi) / at.geometricCosine(photon.wi);
        const Real weight =
            settings.cone > 0 ? 1 - std::sqrt(one.squaredDistance / near.squaredRadius) / settings.cone : 1;
        sum += weight * cosines * at.f(photon.wi, TransportMode::Radiance) * photon.power;
    }
    // The weights' mean over the disc. Source: Jensen 1996, 3.
    const Real mean = settings.cone > 0 ? 1 - 2 / (3 * settings.cone) : 1;
    return sum / (mean * std::numbers::pi * near.squaredRadius);
    //! [ex-08.7]
}

}  // namespace caustic
