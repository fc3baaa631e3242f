#include "integrator/photon.h"

#include "core/not_implemented.h"

namespace caustic {

PhotonWay scatteredWay(PhotonWay way, bool delta) {
    //! [ex-08.1]
    if (way == PhotonWay::Indirect || !delta) return PhotonWay::Indirect;
    return PhotonWay::Caustic;
    //! [ex-08.1]
}

}  // namespace caustic
