#include "measures/floor_caustic.h"

#include "camera/box_filter.h"
#include "core/thread_clock.h"
#include "image/image_file.h"
#include "integrator/render.h"
#include "modeler/caustic_scene.h"
#include "sampling/independent_sampler.h"

namespace caustic {

namespace {

// The mean of blocks of pixels.
Image shrunk(const Image& picture, int width) {
    const int block = picture.width() / width;
    Image small(width, width);
    for (int y = 0; y < width; ++y) {
        for (int x = 0; x < width; ++x) {
            Color sum = Color::Zero();
            for (int i = 0; i < block * block; ++i) sum += picture.at(x * block + i % block, y * block + i / block);
            small.set(x, y, sum / (block * block));
        }
    }
    return small;
}

}  // namespace

FloorCaustic::FloorCaustic(FigureContext& context)
    : scene_(CausticScene{}.onFloor(width)),
      reference_(shrunk(loadImage(context.asset("assets/references/caustic_floor.exr")), width)) {}

FloorCaustic::Taken FloorCaustic::byPhotons(const PhotonMapperSettings& settings, std::int64_t paths,
                                            std::uint64_t seed) const {
    const IndependentSampler sampler(seed);
    const BoxFilter filter;
    const double start = threadSeconds();
    PhotonMapper mapper(scene_, sampler, filter, settings, 1);
    const Rendering rendering = render(mapper, {.passes = paths});
    return {rendering.film.image(), threadSeconds() - start};
}

}  // namespace caustic
