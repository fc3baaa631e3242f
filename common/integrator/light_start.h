#pragma once

#include "integrator/light_choice.h"
#include "sampling/sampler.h"
#include "scene/scene.h"

namespace caustic {

/// How a path from a light sets out.
struct LightStart {
    ChosenLight light;
    EmissionSample emission;     ///< of that light
    Color beta = Color::Zero();  ///< throughput of the first segment, W
    MediumStack media;           ///< what it starts in
};

/// Picks a light and what leaves it: the start of light paths and of photons.
/// @param numbers  a light path's
/// @return nothing when no light shines, or the light gives no sample
std::optional<LightStart> startAtLight(const Scene& scene, const LightChoice& lights, const PathNumbers& numbers);

}  // namespace caustic
