#include "one_page_path_tracer.h"

#include "integrator/direct_light.h"
#include "integrator/roulette.h"
#include "integrator/scatter.h"

namespace caustic {

Color OnePagePathTracer::Li(const Ray& eye, const MediumStack& media, const PathNumbers& numbers,
                            RayCounts& counts) const {
    //! [path-tracer]
    Color L = Color::Zero();     // what the path has brought
    Color beta = Color::Ones();  // what light that is found now is multiplied by
    Real etaScale = 1;           // radiance is larger in glass; roulette must not take that for brightness
    bool lightSampled = false;   // at the vertex before: then a light must not count again when it is hit
    Ray ray = eye;
    MediumStack in = media;
    for (int vertex = 0; vertex < maxLength_; ++vertex) {
        Color weight;
        const auto at = scene().follow(ray, in, weight, numbers, vertex, counts);
        beta *= weight;

        // Emission: Le
        if (!lightSampled) L += beta * (at ? at->Le() : scene().Le(ray));
        if (!at || !at->scatters() || vertex + 1 == maxLength_) break;

        // Direct light: a point of a lamp
        if (at->connectible()) {
            if (const auto direct = sampleDirectLight(scene(), lights_, *at, vertex, numbers, counts))
                L += beta * direct->value;
        }

        // Scatter: f |cos| / p
        const auto next = scatter(*at, TransportMode::Radiance, numbers, vertex);
        if (!next) break;
        beta *= next->weight;
        if ((beta == 0).all()) break;
        etaScale *= next->sample.eta * next->sample.eta;
        lightSampled = !next->sample.delta();

        // Roulette, from the second vertex on
        if (vertex > 0) {
            const auto survivor =
                roulette(beta * etaScale, numbers.number(Dimension::vertex(vertex, VertexUse::Roulette)));
            if (!survivor) break;
            beta *= *survivor;
        }
        ray = at->spawn(next->sample.wi);
        in = at->media(next->sample.wi);
    }
    return L;
    //! [path-tracer]
}

}  // namespace caustic
