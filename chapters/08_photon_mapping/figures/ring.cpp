#include "core/progress.h"
#include "figures.h"
#include "image/image_file.h"
#include "image/tone_mapping.h"
#include "integrator/render.h"
#include "picture.h"
#include "scenes.h"

namespace caustic {

void drawRing(FigureContext& context) {
    const Scene scene(goldRing(context.byQuality(240, 720), context.byQuality(180, 540)));
    PhotonMapperSettings settings;
    settings.photons = context.byQuality(200'000, 2'000'000);
    settings.caustics = {.nearest = 80, .radius = 0.05};
    settings.density.radius = 0.2;
    context.progress().expect(progressSteps);
    const Image picture = photonPicture(scene, settings, context.byQuality(1, 9), context);
    saveImage(context.output("ring.png"), toneMapped(picture, 1, 4));
}

}  // namespace caustic
