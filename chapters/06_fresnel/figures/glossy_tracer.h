#pragma once

#include "integrator/ray_tracer.h"

namespace caustic {

/// The report's way to glossy reflection: where a surface isn't diffuse, the path goes on into one direction that its
/// BSDF picks, and very many paths a pixel blur into the picture. At the first diffuse surface it asks the lights, as
/// RayTracer does, and ends. So glossy surfaces see lamps with an extent only. Chapter 07 does better.
class GlossyTracer final : public Integrator {
public:
    /// @param maxDepth  surfaces in a row, at most; at least 1
    GlossyTracer(const Scene& scene, const Sampler& sampler, const PixelFilter& filter, int maxDepth)
        : Integrator(scene, sampler, filter), atDiffuse_(scene, sampler, filter, {}), maxDepth_(maxDepth) {}

    Color Li(const Ray& ray, const MediumStack& media, const PathNumbers& numbers, RayCounts& counts) const override;

private:
    RayTracer atDiffuse_;
    int maxDepth_;
};

}  // namespace caustic
