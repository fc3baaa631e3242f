#include "figures/picture.h"

#include <stdexcept>
#include <string>

#include "image/tone_mapping.h"
#include "integrator/render.h"

namespace caustic {

Image takePicture(const Integrator& integrator, int perAxis, FigureContext& context) {
    const Rendering rendering = render(integrator, std::int64_t{perAxis} * perAxis, context.threads());
    if (const auto& bad = rendering.film.firstBad())
        throw std::runtime_error("pixel (" + std::to_string(bad->pixel.x) + ", " + std::to_string(bad->pixel.y) +
                                 "), sample " + std::to_string(bad->index) + " is not finite");
    return toneMapped(rendering.film.image(), 1.3, 4);
}

}  // namespace caustic
