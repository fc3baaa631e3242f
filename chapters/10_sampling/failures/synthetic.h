#pragma once

#include <functional>

#include "integrator/integrator.h"

namespace caustic {

/// A method without a scene to speak of: what a path brings is a function of its place on the film and of a further
/// number, uniform in [0, 1).
class SyntheticIntegrator final : public Integrator {
public:
    using Value = std::function<Real(const Vec2& film, Real number)>;

    /// The first three are kept by reference.
    SyntheticIntegrator(const Scene& scene, const Sampler& sampler, const PixelFilter& filter, Value value)
        : Integrator(scene, sampler, filter), value_(std::move(value)) {}

    Color Li(const Ray&, const MediumStack&, const PathNumbers&, RayCounts&) const override { return Color::Zero(); }

    Color tracePath(const PathId& path, std::vector<Splat>&, RayCounts&) const override {
        const PathNumbers numbers = sampler().start(eyeStream, path.pixel, path.index);
        const Vec2 film =
            Vec2(path.pixel.x + 0.5, path.pixel.y + 0.5) + filter().sample(numbers.pair(Dimension::film()));
        return Color::Constant(value_(film, numbers.number(Dimension::vertex(0, VertexUse::Lobe))));
    }

private:
    Value value_;
};

/// Nothing, seen by a camera of so many pixels.
Scene emptyPicture(int width, int height);

}  // namespace caustic
