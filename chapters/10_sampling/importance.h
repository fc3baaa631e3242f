#pragma once

#include <string>

#include "integrator/integrator.h"

namespace caustic {

/// With which density a direction is sampled that may lead to a lamp.
enum class Importance {
    Uniform,  ///< all directions above the surface alike
    Cosine,   ///< in proportion to the cosine, as light counts
    Lamp,     ///< towards a point of the lamp
    Both      ///< cosine or lamp, each half of the time; divided by the mean of both densities
};

/// What a density is called.
std::string nameOf(Importance density);

/// Light that comes to what the eye sees straight from a lamp, by one ray a path: the integral ∫ f Le cos dω by one
/// sample over its density, whichever that is. Of scenes with one lamp.
/// Source: Veach 1997, eq. 2.10; Both: eq. 9.8 and 9.15, the balance heuristic with one sample.
class ImportanceTracer final : public Integrator {
public:
    /// All are kept by reference.
    ImportanceTracer(const Scene& scene, const Sampler& sampler, const PixelFilter& filter, Importance density)
        : Integrator(scene, sampler, filter), density_(density) {}

    Color Li(const Ray& ray, const MediumStack& media, const PathNumbers& numbers, RayCounts& counts) const override;

private:
    std::optional<Vec3> sample(const Interaction& at, const PathNumbers& numbers) const;
    Real pdfW(const Interaction& at, const Vec3& wi, const Hit& onLamp) const;

    Importance density_;
};

}  // namespace caustic
