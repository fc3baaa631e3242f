#include "figures/profile_picture.h"

#include <algorithm>

#include "curve/profile_file.h"
#include "figures/lit_color.h"
#include "image/image_file.h"
#include "image/ray_view.h"
#include "surface/surface_of_revolution.h"

namespace caustic {

void drawProfile(const std::string& file, const ChapterOptions& options) {
    const SurfaceOfRevolution surface(loadProfile(file));
    const Bounds3 box = surface.bounds();
    const Real size = box.diagonal().norm();
    RayView view;
    view.target = box.center();
    view.eye = box.center() + size * Vec3(0, 0.75, 2.2);
    view.height = 1.1 * size;
    const bool report = options.quality == Quality::Report;
    const int side = report ? 900 : 450;
    const Image picture = supersampled(
        view, side, side, report ? 4 : 2,
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
