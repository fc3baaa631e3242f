#pragma once

#include <cstdint>

#include "figure/figure.h"
#include "image/image.h"
#include "integrator/photon_mapper.h"

namespace caustic {

/// The caustic of chapter 07's glass ball on its floor, and the picture of it that a program made which knows this
/// scene alone and shares no code with any renderer.
class FloorCaustic {
public:
    /// Pixels of a side.
    static constexpr int width = 32;

    /// Reads the reference.
    explicit FloorCaustic(FigureContext& context);

    /// The scene.
    const Scene& scene() const { return scene_; }
    /// What it looks like.
    const Image& reference() const { return reference_; }

    /// A picture, and the computing time of one thread that it took.
    struct Taken {
        Image picture;
        double seconds = 0;
    };

    /// By photon mapping: photons and eye, `paths` a pixel.
    Taken byPhotons(const PhotonMapperSettings& settings, std::int64_t paths, std::uint64_t seed) const;

private:
    Scene scene_;
    Image reference_;
};

}  // namespace caustic
