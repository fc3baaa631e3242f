#include "figures/picture.h"

#include "camera/tent_filter.h"
#include "image/tone_mapping.h"
#include "integrator/render.h"
#include "sampling/stratified_sampler.h"

namespace caustic {

Image takePicture(const SceneDescription& description, const PictureSettings& settings, FigureContext& context) {
    const Scene scene(description);
    const StratifiedSampler sampler(context.seed(), settings.perAxis);
    const TentFilter filter;
    RayTracer tracer(scene, sampler, filter, settings.tracer);
    const Rendering rendering =
        render(tracer, {.passes = settings.perAxis * settings.perAxis, .threads = context.threads()});
    requireFinite(rendering);
    return toneMapped(rendering.film.image(), settings.exposure, settings.white);
}

}  // namespace caustic
