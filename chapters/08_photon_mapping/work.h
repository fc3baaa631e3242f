#pragma once

#include <cstdint>

#include "figure/figure.h"
#include "integrator/photon_mapper.h"
#include "scene/scene_description.h"

namespace caustic {

/// What each method does in ten seconds of one thread on the caustic before a mirror: measured once by --recalibrate,
/// so that methods.png is the same on every machine.
struct CausticWork {
    /// Pixels of the picture.
    static constexpr int width = 200;
    static constexpr int height = 150;
    /// Segments of a path, at most.
    static constexpr int segments = 16;

    std::int64_t pathSamples = 0;           ///< paths a pixel, of path tracing
    std::int64_t bidirectionalSamples = 0;  ///< of bidirectional path tracing
    std::int64_t photonSamples = 0;         ///< of photon mapping
    std::int64_t photons = 0;               ///< that set out for it
};

/// The scene, chapter 07's.
SceneDescription causticBeforeMirror();

/// How photons are used for it.
PhotonMapperSettings causticSettings(std::int64_t photons);

/// Reads the counts from work.json beside the chapter; for a draft a sixteenth of them.
/// @throws InputError when the file isn't what --recalibrate writes
CausticWork causticWork(const ChapterInputs& chapter, Quality quality);

/// Measures the counts anew and writes work.json: --recalibrate SECONDS, so many of each method, greater than 0.
void recalibrate(double seconds, const ChapterInputs& chapter);

}  // namespace caustic
