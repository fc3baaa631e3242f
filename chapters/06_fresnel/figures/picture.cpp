#include "figures/picture.h"

#include "image/tone_mapping.h"
#include "integrator/render.h"

namespace caustic {

Image takePicture(Integrator& integrator, int perAxis, FigureContext& context) {
    const Rendering rendering =
        render(integrator, {.passes = std::int64_t{perAxis} * perAxis, .threads = context.threads()});
    requireFinite(rendering);
    return toneMapped(rendering.film.image(), 1.3, 4);
}

}  // namespace caustic
