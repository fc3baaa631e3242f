#include "integrator/vertex_connection.h"

#include <cmath>

#include "core/not_implemented.h"

namespace caustic {

std::optional<VertexConnection> connectVertices(const Scene& scene, const WalkEnd& eye, const WalkEnd& light,
                                                RayCounts& counts) {
    //! [ex-07.6]
    const Vec3 way = light.at.point() - eye.at.point();
    const Real squaredDistance = way.squaredNorm();
    if (!(squaredDistance > 0)) return std::nullopt;
    const Vec3 wi = way / std::sqrt(squaredDistance);
    const Color atEye = eye.at.f(wi, TransportMode::Radiance);
    if ((atEye == 0).all()) return std::nullopt;
    const Color atLight = light.at.f(-wi, TransportMode::Importance);
    if ((atLight == 0).all()) return std::nullopt;
    const Color passed = scene.transmittance(eye.at.spawnTo(light.at), eye.at.media(wi), counts);
    if ((passed == 0).all()) return std::nullopt;
    // Veach 1997, eq. 10.8, with G of 8.1.
    const Real geometry = eye.at.cosine(wi) * light.at.cosine(-wi) / squaredDistance;
    return VertexConnection{wi, squaredDistance, eye.beta * atEye * geometry * passed * atLight * light.beta};
    //! [ex-07.6]
}

}  // namespace caustic
