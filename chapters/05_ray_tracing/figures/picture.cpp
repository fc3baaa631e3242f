#include "figures/picture.h"

#include <stdexcept>
#include <string>

#include "camera/tent_filter.h"
#include "image/tone_mapping.h"
#include "integrator/render.h"
#include "sampling/stratified_sampler.h"

namespace caustic {

Image takePicture(const SceneDescription& description, const PictureSettings& settings, FigureContext& context) {
    const Scene scene(description);
    const StratifiedSampler sampler(context.seed(), settings.perAxis);
    const TentFilter filter;
    const RayTracer tracer(scene, sampler, filter, settings.tracer);
    const Rendering rendering = render(tracer, settings.perAxis * settings.perAxis, context.threads());
    if (const auto& bad = rendering.film.firstBad())
        throw std::runtime_error("pixel (" + std::to_string(bad->pixel.x) + ", " + std::to_string(bad->pixel.y) +
                                 "), sample " + std::to_string(bad->index) + " is not finite");
    return toneMapped(rendering.film.image(), settings.exposure, settings.white);
}

}  // namespace caustic
