#pragma once

#include "integrator/integrator.h"

namespace caustic {

/// How far and how fine a RayTracer goes.
struct RayTracerSettings {
    /// Reflections and refractions in a row, at most; at least 0. What comes after them is lost.
    int maxDepth = 8;

    /// A ray that counts no more than this isn't followed; in [0, 1). It counts what the lobes and the ways before it
    /// have left of light's energy, the largest channel: eta² undoes what TransportMode::Radiance divides by. Each
    /// boundary then loses less than its share of it.
    Real leastWeight = 0;

    /// Points sampled of each light with an extent at each non-specular surface, at least 1.
    int shadowSamples = 1;
};

/// Recursive ray tracing: at each surface, the light that comes straight from the lights is scattered by its diffuse
/// and glossy lobes, and every delta lobe is followed with a ray of its own. Light that comes over other diffuse
/// surfaces is missing; the scene's ambient light stands for it. Light that reaches a diffuse surface through glass is
/// missing. Source: Whitted 1980, An Improved Illumination Model for Shaded Display; soft shadows: Cook, Porter,
/// Carpenter 1984.
class RayTracer final : public Integrator {
public:
    /// @throws InputError when a setting is out of its range
    RayTracer(const Scene& scene, const Sampler& sampler, const PixelFilter& filter, const RayTracerSettings& settings);

    Color Li(const Ray& ray, const MediumStack& media, const PathNumbers& numbers, RayCounts& counts) const override;

    /// Light that comes to a surface straight from the lights, all of them, and leaves it along wo, W/(m²·sr); 0
    /// unless it is connectible(). Of a light with an extent it is the mean over shadowSamples points, of one with a
    /// delta place its one sample. What is in the way is asked for in the media on the shadow ray's side.
    /// @param vertex   which vertex of the path it is, from 0: LightPoint of that vertex is taken
    /// @param numbers  the path's; each light has a branch of them, and each of its samples a part of that
    Color direct(const Interaction& at, int vertex, const PathNumbers& numbers, RayCounts& counts) const;

private:
    // A ray on its way.
    struct Branch {
        Ray ray;            // unit direction
        MediumStack media;  // what it starts in
        int depth = 0;      // delta lobes before it; its first vertex has this number
        Real weight = 1;    // share of the energy: each lobe's f · transmittance, its largest channel, times eta²
    };
    // What is seen along it. Lobes are followed up to maxDepth, where they weigh more than leastWeight.
    Color trace(const Branch& branch, const PathNumbers& numbers, RayCounts& counts) const;
    Color ambient(const Interaction& at, int vertex, const PathNumbers& numbers) const;

    RayTracerSettings settings_;
};

}  // namespace caustic
