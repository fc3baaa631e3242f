#include "picture.h"

#include "camera/box_filter.h"
#include "integrator/render.h"
#include "sampling/independent_sampler.h"

namespace caustic {

Image pictureBy(Integrator& integrator, std::int64_t samples, FigureContext& context) {
    const Rendering rendering =
        render(integrator, {.passes = samples, .threads = context.threads(), .progress = &context.progress()});
    requireFinite(rendering);
    return rendering.film.image();
}

Image photonPicture(const Scene& scene, const PhotonMapperSettings& settings, std::int64_t samples,
                    FigureContext& context) {
    const IndependentSampler sampler(context.seed());
    const BoxFilter filter;
    PhotonMapper mapper(scene, sampler, filter, settings, context.threads());
    return pictureBy(mapper, samples, context);
}

}  // namespace caustic
