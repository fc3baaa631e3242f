#pragma once

#include "core/not_implemented.h"
#include "integrator/path_limits.h"
#include "integrator/roulette.h"
#include "integrator/scatter.h"
#include "scene/scene.h"

namespace caustic {

/// A path on its way: its next segment, what it carries, and all that it takes to go on. A value: a copy goes on as the
/// path itself would, so a path is split by copying it.
struct WalkState {
    /// A path that sets out.
    /// @param first  its first segment, unit direction
    /// @param in     the media that it starts in
    /// @param carried  throughput; at least one channel greater than 0
    WalkState(const Ray& first, const MediumStack& in, const Color& carried)
        : ray(first), media(in), beta(carried), start(carried.maxCoeff()) {}

    /// Goes on from the vertex at which the path is, behind it afterwards.
    /// @param sample  how it is scattered there
    /// @param weight  what that multiplies the throughput by: f |cos| / p, or f of a delta lobe that is followed for
    /// sure
    void leave(const Interaction& at, const BsdfSample& sample, const Color& weight, TransportMode mode) {
        beta *= weight;
        if (mode == TransportMode::Radiance) etaScale *= sample.eta * sample.eta;
        ray = at.spawn(sample.wi);
        media = at.media(sample.wi);
    }

    Ray ray;            ///< of the next segment, unit direction
    MediumStack media;  ///< what it starts in
    Color beta;         ///< throughput; at a vertex, with the weights of all media on the way to it
    int length = 0;     ///< segments so far

    /// Largest channel of the throughput at the start: what roulette compares with.
    Real start;
    /// Radiance grows and shrinks with the index of refraction; beta times this doesn't. Roulette is about energy.
    Real etaScale = 1;
};

/// A path goes on from a vertex: scatters, plays roulette, and sets out on its next segment.
/// @param path     at the vertex; afterwards behind it
/// @param at       the vertex, which scatters()
/// @param numbers  the path's
/// @return how it was scattered; nothing when the path ends here
inline std::optional<BsdfSample> leaveVertex(WalkState& path, const Interaction& at, TransportMode mode,
                                             const PathLimits& limits, const PathNumbers& numbers) {
    //! [leave-vertex]
    const int vertex = path.length - 1;
    const auto next = scatter(at, mode, numbers, vertex);
    if (!next) return std::nullopt;
    path.leave(at, next->sample, next->weight, mode);
    if ((path.beta == 0).all()) return std::nullopt;
    if (vertex >= limits.rouletteStart) {
        const Real u = numbers.number(Dimension::vertex(vertex, VertexUse::Roulette));
        const auto survivor = roulette(path.beta * (path.etaScale / path.start), u);
        if (!survivor) return std::nullopt;
        path.beta *= *survivor;
    }
    return next->sample;
    //! [leave-vertex]
}

/// A random walk through the scene: follows the ray to a vertex, a surface or a point of a medium that scatters; goes
/// on from there, and so on, until the path leaves the scene, is absorbed, loses at roulette or is as long as it may
/// be. One walk serves paths from the eye, paths from lights and photons; what they differ in is the visitor's. It is
/// told of everything that happens:
///
///     bool reached(const Interaction& at, const WalkState& path);        // at a vertex; false ends the walk
///     void scattered(const Interaction& at, const BsdfSample& sample);   // and goes on from it
///     void escaped(const WalkState& path);                               // it left the scene along path.ray
///
/// To split a path, `reached` copies its state for each part, sends the part on with WalkState::leave, or with
/// leaveVertex and a share of the throughput, then with walk and numbers of its own (PathNumbers::part, branch), and
/// returns false.
///
/// Source: Veach 10.
/// @param path     one that sets out, or goes on
/// @param mode     Radiance for paths from the eye, Importance for those from lights
/// @param numbers  the path's; vertex 0 is the first behind the start
/// @param counts   what is done in the scene is added
template <typename Visitor>
void walk(const Scene& scene, WalkState path, TransportMode mode, const PathLimits& limits, const PathNumbers& numbers,
          RayCounts& counts, Visitor& visitor) {
    //! [ex-07.2]
    for (;;) {
        Color weight;
        const std::optional<Interaction> at = scene.follow(path.ray, path.media, weight, numbers, path.length, counts);
        path.beta *= weight;
        ++path.length;
        if (!at) return visitor.escaped(path);
        if (!visitor.reached(*at, path) || !at->scatters() || path.length >= limits.maxLength) return;
        const auto sample = leaveVertex(path, *at, mode, limits, numbers);
        if (!sample) return;
        visitor.scattered(*at, *sample);
    }
    //! [ex-07.2]
}

}  // namespace caustic
