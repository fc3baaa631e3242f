#include "figures/picture.h"

#include "camera/box_filter.h"
#include "core/progress.h"
#include "integrator/picture.h"
#include "sampling/sobol_sampler.h"

namespace caustic {

static_assert(pictureSteps == progressSteps);

Image sppmPicture(const Scene& scene, const SppmSettings& settings, std::int64_t passes, FigureContext& context) {
    const SobolSampler sampler(context.seed());
    const BoxFilter filter;
    Sppm sppm(scene, sampler, filter, settings);
    return renderImage(sppm, passes, context, &context.progress());
}

}  // namespace caustic
