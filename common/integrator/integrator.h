#pragma once

#include <memory>
#include <span>
#include <vector>

#include "camera/film.h"
#include "camera/pixel_filter.h"
#include "sampling/sampler.h"
#include "scene/scene.h"

namespace caustic {

/// Which path to trace: a pixel, and the how-manieth of it.
struct PathId {
    Pixel pixel;
    std::int64_t index = 0;  ///< from 0
};

/// A contribution to any place of the film.
struct Splat {
    Vec2 film = Vec2::Zero();     ///< in pixels
    Color value = Color::Zero();  ///< what it adds, before it is divided by the number of paths
};

/// What a pass brings, in an order that doesn't depend on threads.
struct PassBuffer {
    std::vector<Color> values;  ///< one for each path of the list, in its order; radiance, W/(m²·sr)
    std::vector<Splat> splats;  ///< from paths that started at lights
    RayCounts counts;           ///< what was asked of the scene
};

/// Estimates the radiance that arrives at each pixel, and so the picture.
///
/// The same list gives the same buffer, bit for bit, for any number of threads. Time limits, adaptive sampling,
/// progressive methods and checkpoints are all made of passes.
class Integrator {
public:
    /// All three are kept by reference and have to live as long.
    Integrator(const Scene& scene, const Sampler& sampler, const PixelFilter& filter)
        : scene_(&scene), sampler_(&sampler), filter_(&filter) {}
    virtual ~Integrator() = default;

    /// The radiance that comes in along a ray, estimated with the path's numbers, W/(m²·sr).
    /// @param media   what the ray starts in
    /// @param counts  what was asked of the scene is added
    virtual Color Li(const Ray& ray, const MediumStack& media, const PathNumbers& numbers, RayCounts& counts) const = 0;

    /// Renders a list of paths.
    /// @param threads  at least 1
    virtual PassBuffer runPass(std::span<const PathId> paths, int threads) const;

    /// Traces one path: the value of its pixel. What it brings to any other place of the film is appended to `splats`.
    /// @param counts  what was asked of the scene is added
    virtual Color tracePath(const PathId& path, std::vector<Splat>& splats, RayCounts& counts) const;

    /// What is rendered.
    const Scene& scene() const { return *scene_; }
    /// How pixels weigh the film.
    const PixelFilter& filter() const { return *filter_; }

protected:
    /// Streams of numbers: of what starts at the eye, and of what starts at a light.
    static constexpr std::uint64_t eyeStream = 0;
    static constexpr std::uint64_t lightStream = 1;

    /// Where random numbers come from.
    const Sampler& sampler() const { return *sampler_; }

    /// The ray that a path starts with at the eye: a point of the film, picked by the pixel filter, and one of the
    /// lens.
    Ray eyeRay(const PathId& path, const PathNumbers& numbers, RayCounts& counts) const;

private:
    const Scene* scene_;
    const Sampler* sampler_;
    const PixelFilter* filter_;
};

}  // namespace caustic
