#include "figures/picture.h"

#include "camera/tent_filter.h"
#include "integrator/picture.h"
#include "sampling/stratified_sampler.h"

namespace caustic {

Image takePicture(const SceneDescription& description, const PictureSettings& settings, FigureContext& context) {
    const Scene scene(description);
    const StratifiedSampler sampler(context.seed(), settings.perAxis);
    const TentFilter filter;
    RayTracer tracer(scene, sampler, filter, settings.tracer);
    return takePicture(tracer, settings.perAxis * settings.perAxis, settings.tone, context);
}

}  // namespace caustic
