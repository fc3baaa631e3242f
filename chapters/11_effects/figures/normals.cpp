#include "dented_ball.h"
#include "figures.h"
#include "figures/picture.h"
#include "image/tiles.h"
#include "light/environment_map.h"
#include "maps.h"

namespace caustic {

void drawNormals(FigureContext& context) {
    const Frame upright = {Vec3(0, 0, -1), Vec3(-1, 0, 0), Vec3(0, 1, 0)};
    const auto hall = environmentLight(loadPanorama(context.asset("assets/environments/esplanade.exr")), upright);
    const auto tile = [&](const std::string& caption, Normals normals, Lookup lookup) {
        return Tile{caption, [&context, hall, normals, lookup](int side, int) {
                        return tracedPicture(Scene(dentedBall(normals, lookup, hall, side)), context.byQuality(2, 16),
                                             {.exposure = 0.6}, context);
                    }};
    };
    drawTiles({tile("smooth", Normals::Smooth, Lookup::Nearest),
               tile("mapped, nearest pixel", Normals::Mapped, Lookup::Nearest),
               tile("mapped, bilinear", Normals::Mapped, Lookup::Bilinear),
               tile("bilinear, not bent: black at the rim", Normals::Bare, Lookup::Bilinear)},
              400, 400, "normals.png", context);
}

}  // namespace caustic
