#pragma once

#include "integrator/integrator.h"
#include "integrator/light_choice.h"

namespace caustic {

/// The whole path tracer on one page: a loop that a reader follows from top to bottom, with the same functions that the
/// other integrators call. It does what PathTracer does with Direct::DirectLight, bit for bit. PathTracer does the
/// rest: the other ways to meet a light, and their weights.
class OnePagePathTracer final : public Integrator {
public:
    /// @param maxLength  segments between eye and light, at most; at least 1
    OnePagePathTracer(const Scene& scene, const Sampler& sampler, const PixelFilter& filter, int maxLength)
        : Integrator(scene, sampler, filter), maxLength_(maxLength), lights_(scene.lights()) {}

    Color Li(const Ray& eye, const MediumStack& media, const PathNumbers& numbers, RayCounts& counts) const override;

private:
    int maxLength_;
    LightChoice lights_;
};

}  // namespace caustic
