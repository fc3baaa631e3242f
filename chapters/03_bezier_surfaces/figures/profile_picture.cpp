#include "figures/profile_picture.h"

#include <algorithm>

#include "curve/profile_file.h"
#include "figures/ray_picture.h"
#include "image/image_file.h"
#include "surface/surface_of_revolution.h"

namespace caustic {

void drawProfile(const std::string& file, const ChapterOptions& options) {
    const SurfaceOfRevolution surface(loadProfile(file));
    const Bounds3 box = surface.bounds();
    const Real size = box.diagonal().norm();
    Eye eye;
    eye.target = box.center();
    eye.place = box.center() + size * Vec3(0, 0.75, 2.2);
    eye.height = 1.1 * size;
    const bool report = options.quality == Quality::Report;
    const int side = report ? 900 : 450;
    const Image picture = pictureOf(
        eye, side, side, report ? 4 : 2,
        [&](const Ray& ray) {
            const auto hit = surface.intersect(ray);
            return hit ? litColor(*hit, -ray.direction, Vec3::UnitY(), Color(0.16, 0.42, 0.7)) : paperColor();
        },
        options.threads);
    const std::filesystem::path folder = options.out / "03_bezier_surfaces";
    std::filesystem::create_directories(folder);
    saveImage(folder / "revolved.png", picture);
}

}  // namespace caustic
