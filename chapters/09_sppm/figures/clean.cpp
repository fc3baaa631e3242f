#include "core/progress.h"
#include "figures.h"
#include "figures/picture.h"
#include "image/image_file.h"
#include "image/tiles.h"
#include "image/tone_mapping.h"
#include "modeler/caustic_scene.h"
#include "modeler/peers_box.h"
#include "scenes.h"

namespace caustic {

void drawClean(FigureContext& context) {
    const std::int64_t passes = context.byQuality(8, 200);
    context.progress().expect(2 * pictureSteps);
    const auto shown = [](const Image& picture) { return toneMapped(picture, 1, 4); };
    const auto converged = [&](const std::string& file) {
        return [&context, &shown, file](int, int) { return shown(loadImage(context.asset(file))); };
    };
    const auto clean = [&](SceneDescription description, const std::string& settings) {
        const auto scene = std::make_shared<Scene>(std::move(description));
        return [&context, &shown, scene, settings, passes](int, int) {
            return shown(sppmPicture(*scene, namedScene(settings).settings, passes, context));
        };
    };
    const std::string after = "SPPM, " + std::to_string(passes) + " passes";
    const CausticScene caustic = {.lampSide = 0.2};
    drawTiles({{"bidirectional path tracing, minutes", converged("assets/references/peers_box.exr")},
               {after, clean(peersBox(256, 256), "peers_box")}},
              512, 512, "clean_box.png", context, 2);
    drawTiles({{"bidirectional path tracing, minutes", converged("assets/references/caustic_mirror.exr")},
               {after, clean(caustic.beforeMirror(200, 150), "caustic_mirror")}},
              600, 450, "clean_mirror.png", context, 2);
}

}  // namespace caustic
