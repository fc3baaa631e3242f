#pragma once

#include <cstdint>
#include <string>

#include "figure/figure.h"
#include "image/image.h"
#include "integrator/volume_sppm.h"

namespace caustic {

/// What --final was told.
struct FinalWishes {
    std::int64_t width = 1600;       ///< of the picture; it is five eighths as high
    std::int64_t passes = 40;        ///< in all
    std::int64_t photons = 1 << 19;  ///< a pass
    std::string checkpoint;          ///< file to go on from, when it is there, and to write to; empty for none
    std::int64_t every = 4;          ///< passes between two checkpoints
};

/// Renders the course's final picture to `<out>/11_effects/final.png`, pass by pass. With a checkpoint file it goes on
/// where that stands, and writes it anew on the way and at the end; the picture is the same, bit for bit, as without
/// the stop.
/// @throws InputError for a checkpoint of another picture, or a damaged one, and as finalScene does
void renderFinal(const FinalWishes& wishes, const ChapterInputs& chapter, const ChapterOptions& options);

/// How the final picture is rendered.
VolumeSppmSettings finalSettings(int photons);

/// Tone-maps the final picture's radiances.
Image developedFinal(const Image& radiance);

}  // namespace caustic
