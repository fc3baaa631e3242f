#include "integrator/near_lamps.h"

#include <algorithm>

namespace caustic {

std::vector<bool> pixelsNearLamps(const Scene& scene, int reach) {
    constexpr int perPixel = 4;  // rays, squared
    const Camera& camera = scene.camera();
    std::vector<bool> near(static_cast<std::size_t>(camera.width() * camera.height()), false);
    RayCounts counts;
    const auto mark = [&](int x, int y) {
        for (int j = std::max(0, y - reach); j <= std::min(camera.height() - 1, y + reach); ++j) {
            for (int i = std::max(0, x - reach); i <= std::min(camera.width() - 1, x + reach); ++i)
                near[static_cast<std::size_t>(j * camera.width() + i)] = true;
        }
    };
    for (int y = 0; y < perPixel * camera.height(); ++y) {
        for (int x = 0; x < perPixel * camera.width(); ++x) {
            const Ray ray = camera.sampleRay({(x + 0.5) / perPixel, (y + 0.5) / perPixel}, {0.5, 0.5});
            MediumStack media = scene.cameraMedia();
            Color passed;
            const auto at = scene.follow(ray, media, passed, counts);
            if (at && at->light() != nullptr) mark(x / perPixel, y / perPixel);
        }
    }
    return near;
}

}  // namespace caustic
