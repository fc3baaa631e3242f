#include "integrator/photon.h"

#include "core/not_implemented.h"

namespace caustic {

PhotonWay scatteredWay(PhotonWay way, bool delta) {
    //! [ex-08.1]
    if (way == PhotonWay::Indirect || !delta) return PhotonWay::Indirect;
    return PhotonWay::Caustic;
    //! [ex-08.1]
}

std::vector<Vec3> pointsOf(std::span<const Photon> photons) {
    std::vector<Vec3> points;
    points.reserve(photons.size());
    for (const Photon& photon : photons) points.push_back(photon.point);
    return points;
}

}  // namespace caustic
