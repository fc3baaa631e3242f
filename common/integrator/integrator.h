#pragma once

#include <span>
#include <vector>

#include "camera/pixel_filter.h"
#include "core/byte_stream.h"
#include "integrator/rendering.h"
#include "sampling/sampler.h"
#include "scene/scene.h"

namespace caustic {

/// Names a path: a pixel, and which of the pixel's paths it is.
struct PathId {
    Pixel pixel;
    std::int64_t index = 0;  ///< from 0
};

/// A contribution to any place of the film.
struct Splat {
    Vec2 film = Vec2::Zero();     ///< in pixels
    Color value = Color::Zero();  ///< what it adds, before it is divided by the number of paths
};

/// A pass of a rendering: some paths that are traced together. Usually one of each pixel.
struct Pass {
    std::int64_t number = 0;        ///< from 0: which of the rendering's passes
    std::span<const PathId> paths;  ///< in an order that says in which order they are added to the film
};

/// Estimates the radiance that arrives at each pixel, and so the picture.
///
/// A picture is made of passes: time limits, adaptive sampling, progressive methods, checkpoints and several machines
/// are all made of them. A pass gives the same rendering, bit for bit, for any number of threads. Most methods keep
/// nothing from one pass to the next, so their passes may be run in any order, anywhere. A method that does keep
/// something says so; its passes are run in the order of their numbers, by one integrator for each rendering, and what
/// it keeps is what save() and load() write and read.
class Integrator {
public:
    /// All three are kept by reference and have to live as long.
    Integrator(const Scene& scene, const Sampler& sampler, const PixelFilter& filter)
        : scene_(&scene), sampler_(&sampler), filter_(&filter) {}
    virtual ~Integrator() = default;

    /// The radiance that comes in along a ray, estimated with the path's numbers, W/(m²·sr).
    /// @param media   what the ray starts in
    /// @param counts  what is done in the scene is added
    virtual Color Li(const Ray& ray, const MediumStack& media, const PathNumbers& numbers, RayCounts& counts) const = 0;

    /// Runs one pass.
    /// @param threads  at least 1
    /// @return what this pass alone brings, on a film of its own, in an order that doesn't depend on threads
    virtual Rendering runPass(const Pass& pass, int threads);

    /// Traces one path: the value of its pixel. What it brings to any other place of the film is appended to `splats`.
    /// @param counts  what is done in the scene is added
    virtual Color tracePath(const PathId& path, std::vector<Splat>& splats, RayCounts& counts) const;

    /// Adds to the picture, a mean over passes, what isn't one: what the method has kept of all of them.
    virtual void develop(Image&) const {}

    /// Writes what the method keeps from pass to pass, exactly; nothing unless it says otherwise.
    virtual void save(ByteWriter&) const {}

    /// Puts what save() wrote in the place of what is kept.
    /// @throws InputError that names the file when it can't have been written by such a method in such a scene
    virtual void load(ByteReader&) {}

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
