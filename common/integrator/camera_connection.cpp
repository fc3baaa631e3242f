#include "integrator/camera_connection.h"

#include "core/not_implemented.h"

namespace caustic {

namespace {

// Which point of the lens.
Vec2 lensNumbers(const Scene& scene, int vertex, const PathNumbers& numbers, RayCounts& counts) {
    if (!scene.needs().lens) return {0.5, 0.5};
    ++counts.lensSamples;
    return numbers.pair(Dimension::vertex(vertex, VertexUse::Lens));
}

}  // namespace

std::optional<CameraConnection> connectToCamera(const Scene& scene, const Interaction& at, const Color& beta,
                                                int vertex, const PathNumbers& numbers, RayCounts& counts) {
    //! [ex-07.5]
    const auto seen = scene.camera().sampleImportance(at.point(), lensNumbers(scene, vertex, numbers, counts));
    if (!seen) return std::nullopt;
    const Color f = at.f(seen->wi, TransportMode::Importance);
    if ((f == 0).all()) return std::nullopt;
    const Color passed = scene.transmittance(at.spawnTo(seen->lens), at.media(seen->wi), counts);
    if ((passed == 0).all()) return std::nullopt;
    // Veach 1997, eq. 10.8 for t = 1, where We takes the place of the eye's f.
    const Real geometry = at.cosine(seen->wi) * seen->cosine / (seen->distance * seen->distance);
    return CameraConnection{*seen, beta * f * (geometry * seen->We / seen->pdfA) * passed};
    //! [ex-07.5]
}

}  // namespace caustic
