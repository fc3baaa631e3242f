#include "integrator/camera_connection.h"

#include "core/not_implemented.h"
#include "math/spawn.h"

namespace caustic {

namespace {

// Which point of the lens. A light path asks for no point of a light at its vertices: that pair is free.
Vec2 lensNumbers(const Scene& scene, int vertex, const PathNumbers& numbers, RayCounts& counts) {
    if (!scene.needs().lens) return {0.5, 0.5};
    ++counts.lensSamples;
    return numbers.pair(Dimension::vertex(vertex, VertexUse::LightPoint));
}

}  // namespace

std::optional<CameraConnection> connectToCamera(const Scene& scene, const Interaction& at, const Color& beta,
                                                int vertex, const PathNumbers& numbers, RayCounts& counts) {
    //! [ex-07.5]
    const auto seen = scene.camera().sampleImportance(at.hit().point, lensNumbers(scene, vertex, numbers, counts));
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
