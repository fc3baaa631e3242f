#include "picture.h"

#include "camera/box_filter.h"
#include "sampling/independent_sampler.h"

namespace caustic {

Image photonPicture(const Scene& scene, const PhotonMapperSettings& settings, std::int64_t passes,
                    FigureContext& context) {
    const IndependentSampler sampler(context.seed());
    const BoxFilter filter;
    PhotonMapper mapper(scene, sampler, filter, settings, context.threads());
    return renderImage(mapper, passes, context, &context.progress());
}

}  // namespace caustic
