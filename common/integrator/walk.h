#pragma once

#include "integrator/path_limits.h"
#include "integrator/roulette.h"
#include "integrator/scatter.h"
#include "math/spawn.h"
#include "scene/scene.h"

namespace caustic {

/// A path on its way: its next segment and what it carries.
struct WalkState {
    Ray ray;            ///< of the next segment, unit direction
    MediumStack media;  ///< what it starts in
    Color beta;         ///< throughput; at a vertex, with all that the way to it has absorbed
    int length = 0;     ///< segments so far
};

/// A random walk through the scene: follows the ray to a surface, scatters there, and so on until the path leaves the
/// scene, is absorbed, loses at roulette or is as long as it may be. One walk serves paths from the eye, paths from
/// lights and photons; what they differ in is the visitor's. It is told of everything that happens:
///
///     bool reached(const Interaction& at, const WalkState& path);        // at a surface; false ends the walk
///     void scattered(const Interaction& at, const BsdfSample& sample);   // and goes on from it
///     void escaped(const WalkState& path);                               // it left the scene along path.ray
///
/// Source: Veach 10.
/// @param mode     Radiance for paths from the eye, Importance for those from lights
/// @param numbers  the path's; vertex 0 is the first surface
/// @param counts   what was asked of the scene is added
template <typename Visitor>
void walk(const Scene& scene, WalkState path, TransportMode mode, const PathLimits& limits, const PathNumbers& numbers,
          RayCounts& counts, Visitor& visitor) {
    const Real start = path.beta.maxCoeff();
    Real radianceScale = 1;  // radiance grows and shrinks with the index of refraction; roulette is about energy
    for (;;) {
        Color transmittance;
        const std::optional<Interaction> at = scene.follow(path.ray, path.media, transmittance, counts);
        path.beta *= transmittance;
        ++path.length;
        if (!at) return visitor.escaped(path);
        if (!visitor.reached(*at, path) || at->bsdf() == nullptr || path.length >= limits.maxLength) return;

        const int vertex = path.length - 1;
        const auto next = scatter(*at, mode, numbers, vertex);
        if (!next) return;
        path.beta *= next->weight;
        if ((path.beta == 0).all()) return;
        if (mode == TransportMode::Radiance) radianceScale *= next->sample.eta * next->sample.eta;
        if (vertex >= limits.rouletteStart) {
            const Real u = numbers.number(Dimension::vertex(vertex, VertexUse::Roulette));
            const auto survivor = roulette(path.beta * (radianceScale / start), u);
            if (!survivor) return;
            path.beta *= *survivor;
        }
        visitor.scattered(*at, next->sample);
        path.ray = spawnRay(at->hit(), next->sample.wi);
        path.media = at->media(next->sample.wi);
    }
}

}  // namespace caustic
