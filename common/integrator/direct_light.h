#pragma once

#include <optional>

#include "integrator/light_choice.h"
#include "sampling/sampler.h"
#include "scene/scene.h"

namespace caustic {

/// Light that comes to a vertex straight from one of the lights.
struct DirectLight {
    ChosenLight light;
    DirectSample sample;          ///< of that light, as it was given: its own density is of the direction alone
    Real pdfW = 0;                ///< density of choosing this light and then this direction, 1/sr
    Color value = Color::Zero();  ///< what the vertex scatters of it along its wo, divided by pdfW already: an estimate
                                  ///< of what it scatters of all lights, W/(m²·sr)
};

/// Samples the light that comes to a vertex straight from the lights: one of them, and a direction to it. What is in
/// the way is asked for with the sample's ray, in the media on its side of the vertex.
/// @param at      connectible()
/// @param vertex  which vertex of the path it is, from 0: whose numbers are taken, LightChoice for the light and the
///                pair LightPoint for the direction
/// @param counts  what is done in the scene is added
/// @return nothing when no light is chosen, it gives no sample, or all three channels of what comes are 0
std::optional<DirectLight> sampleDirectLight(const Scene& scene, const LightChoice& lights, const Interaction& at,
                                             int vertex, const PathNumbers& numbers, RayCounts& counts);

}  // namespace caustic
