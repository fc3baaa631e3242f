#pragma once

#include <optional>

#include "integrator/light_choice.h"
#include "sampling/sampler.h"
#include "scene/scene.h"

namespace caustic {

/// Light that a surface gets straight from one of the lights.
struct DirectLight {
    ChosenLight light;
    Vec2 u = Vec2::Zero();        ///< the numbers of its sampleDirect: Light::directPoint knows the place by them
    DirectSample sample;          ///< its answer
    Real pdfW = 0;                ///< density of choosing this light and then this direction, 1/sr
    Color value = Color::Zero();  ///< what the surface scatters of it along its wo: an estimate, over pdfW, of what it
                                  ///< scatters of all lights, W/(m²·sr)
};

/// Asks one of the lights for light.
/// @param at      where its bsdf() scatters
/// @param vertex  which vertex of the path it is, from 0: whose numbers are taken
/// @param counts  what was asked of the scene is added
/// @return nothing when none comes from there
std::optional<DirectLight> askForLight(const Scene& scene, const LightChoice& lights, const Interaction& at, int vertex,
                                       const PathNumbers& numbers, RayCounts& counts);

}  // namespace caustic
