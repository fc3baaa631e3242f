#include "figures/picture.h"

#include "camera/box_filter.h"
#include "image/tone_mapping.h"
#include "integrator/path_tracer.h"
#include "sampling/sobol_sampler.h"

namespace caustic {

Image tracedImage(const Scene& scene, std::int64_t paths, FigureContext& context) {
    const SobolSampler sampler(context.seed());
    const BoxFilter filter;
    PathTracer tracer(scene, sampler, filter, {});
    return renderImage(tracer, paths, context);
}

Image tracedPicture(const Scene& scene, std::int64_t paths, const PictureTone& tone, FigureContext& context) {
    return toneMapped(tracedImage(scene, paths, context), tone.exposure, tone.white);
}

}  // namespace caustic
