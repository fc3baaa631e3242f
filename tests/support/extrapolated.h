#pragma once

#include <vector>

#include "integrator/integrator.h"

namespace caustic::test {

/// A method of photons without its bias: the same photons and paths within three radii. Bias is b₁R + b₂R², of edges
/// and of curvature; L(R)/3 − 2 L(R/2) + 8/3 L(R/4) has neither.
template <typename Method>
class Extrapolated final : public Integrator {
public:
    /// @param settingsOf  the method's settings, by the share of the widest radius; the radius must not shrink
    template <typename SettingsOf>
    Extrapolated(const Scene& scene, const Sampler& sampler, const PixelFilter& filter, const SettingsOf& settingsOf)
        : Integrator(scene, sampler, filter) {
        for (const Real share : {1.0, 0.5, 0.25}) parts_.emplace_back(scene, sampler, filter, settingsOf(share));
    }

    Rendering runPass(const Pass& pass, int threads) override {
        const Rendering wide = parts_[0].runPass(pass, threads);
        const Rendering half = parts_[1].runPass(pass, threads);
        const Rendering quarter = parts_[2].runPass(pass, threads);
        Rendering sum = {Film(wide.film.width(), wide.film.height()), wide.counts, 1, 0};
        for (const PathId& path : pass.paths) {
            const auto of = [&](const Rendering& part) { return part.film.value(path.pixel); };
            sum.film.add(path.pixel, path.index, of(wide) / 3 - 2 * of(half) + of(quarter) * (8.0 / 3));
        }
        return sum;
    }

    Color Li(const Ray& ray, const MediumStack& media, const PathNumbers& numbers, RayCounts& counts) const override {
        return parts_[2].Li(ray, media, numbers, counts);
    }

private:
    std::vector<Method> parts_;
};

}  // namespace caustic::test
