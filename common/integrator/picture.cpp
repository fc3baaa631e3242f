#include "integrator/picture.h"

#include "image/tone_mapping.h"

namespace caustic {

Image renderImage(Integrator& integrator, std::int64_t passes, FigureContext& context, Progress* progress) {
    const Rendering rendering =
        render(integrator, {.passes = passes, .threads = context.threads(), .progress = progress});
    requireFinite(rendering);
    return developed(integrator, rendering);
}

Image takePicture(Integrator& integrator, std::int64_t passes, const PictureTone& tone, FigureContext& context) {
    return toneMapped(renderImage(integrator, passes, context), tone.exposure, tone.white);
}

}  // namespace caustic
