#pragma once

#include <algorithm>
#include <numbers>
#include <vector>

#include "integrator/photon_map.h"

namespace caustic {

/// Radiance by the report's rule as it stands there: the sum over the k nearest photons, over π r² with r the distance
/// of the farthest of them. It takes k/(k − 1) times too much in the mean, photons from behind as if they came from
/// above, as many as there are if there are fewer than k, and divides by 0 at a photon.
/// @param radius  photons farther away don't count
inline Color textbookRadiance(const PhotonMap& map, const Interaction& at, int k, Real radius) {
    std::vector<NearPoint> near;
    for (std::uint32_t place = 0; place < map.size(); ++place) {
        const Real squared = (map.photons()[place].point - at.point()).squaredNorm();
        if (squared <= radius * radius) near.push_back({place, squared});
    }
    const auto count = std::min(static_cast<std::size_t>(k), near.size());
    std::partial_sort(near.begin(), near.begin() + static_cast<std::ptrdiff_t>(count), near.end(),
                      [](const NearPoint& a, const NearPoint& b) { return a.squaredDistance < b.squaredDistance; });
    Color sum = Color::Zero();
    for (std::size_t i = 0; i < count; ++i) {
        const Photon& photon = map.photons()[near[i].place];
        // A diffuse surface's f is the same for any two directions of one side.
        sum += at.f(at.wo(), TransportMode::Radiance) * photon.power;
    }
    return sum / (std::numbers::pi * near[count - 1].squaredDistance);
}

}  // namespace caustic
