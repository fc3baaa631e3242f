#include "integrator/camera_connection.h"

#include "core/not_implemented.h"
#include "math/spawn.h"

namespace caustic {

std::optional<CameraConnection> connectToCamera(const Scene& scene, const Interaction& at, const Color& beta,
                                                int vertex, const PathNumbers& numbers, RayCounts& counts) {
    const bool lens = scene.needs().lens;
    counts.lensSamples += lens ? 1 : 0;
    // A light path asks for no point of a light at its vertices: the pair is free.
    const Vec2 u = lens ? numbers.pair(Dimension::vertex(vertex, VertexUse::LightPoint)) : Vec2(0.5, 0.5);
    //! [ex-07.5]
    const auto seen = scene.camera().sampleImportance(at.hit().point, u);
    if (!seen) return std::nullopt;
    const Color f = at.bsdf()->f(at.wo(), seen->wi, TransportMode::Importance);
    if ((f == 0).all()) return std::nullopt;
    const Color passed = scene.transmittance(spawnRayTo(at.hit(), seen->lens), at.media(seen->wi), counts);
    if ((passed == 0).all()) return std::nullopt;
    const Real geometry = at.bsdf()->cosine(seen->wi) * seen->cosine / (seen->distance * seen->distance);
    return CameraConnection{*seen, beta * f * (geometry * seen->We / seen->pdfA) * passed};
    //! [ex-07.5]
}

}  // namespace caustic
