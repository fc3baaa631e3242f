#include "maps.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "image/image_file.h"
#include "image/spherical_map.h"
#include "math/spawn.h"
#include "sampling/warp.h"

namespace caustic {

namespace {

constexpr Real evenPdf = 1 / (4 * std::numbers::pi);

class EvenlySampled final : public Light {
public:
    explicit EvenlySampled(std::shared_ptr<Light> map) : map_(std::move(map)) {}

    void prepare(const Bounds3& scene) override { map_->prepare(scene); }
    bool infinite() const override { return true; }
    std::optional<DirectSample> sampleDirect(const SurfacePoint& from, const Vec2& u) const override {
        const Vec3 wi = uniformSphere(u);
        const Ray ray = spawnRay(from, wi);
        return DirectSample{wi, map_->Le(ray), evenPdf, ray, {}};
    }
    Real pdfW(const Vec3&, const Vec3&) const override { return evenPdf; }
    using Light::pdfW;
    std::optional<EmissionSample> sampleEmission(const Vec2& uPlace, const Vec2& uDirection) const override {
        return map_->sampleEmission(uPlace, uDirection);
    }
    EmissionPdf pdfEmission(const SurfacePoint& at, const Vec3& direction) const override {
        return map_->pdfEmission(at, direction);
    }
    Color Le(const Ray& escaped) const override { return map_->Le(escaped); }
    using Light::Le;
    Color power() const override { return map_->power(); }

private:
    std::shared_ptr<Light> map_;
};

}  // namespace

Image loadPanorama(const std::filesystem::path& file) {
    Image panorama = loadImage(file);
    for (float& value : panorama.data()) value = std::max(value, 0.0F);
    return panorama;
}

Image sunnySky(int height) {
    const Vec3 sun = Vec3(-0.55, 0.6, 0.5).normalized();
    Image sky(2 * height, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < 2 * height; ++x) {
            const Vec3 at = uvToSpherical({(x + 0.5) / (2 * height), (y + 0.5) / height});
            const Real glow = std::pow(std::max(Real(0), at.dot(sun)), 24);
            const Real haze = std::exp(-6 * std::max(Real(0), at.z()));
            const Color above = Color(0.12, 0.24, 0.55) + haze * Color(0.45, 0.32, 0.12) + glow * Color(1.2, 0.8, 0.4);
            sky.set(x, y, at.z() > 0 ? above : Color(0.09, 0.08, 0.07));
        }
    }
    const Vec2 place = sphericalToUv(sun);
    // A disc of half a degree has 6.8e-5 sr: the pixel gets what the sun of 2e4 W/(m²·sr) would give.
    const Real pixel =
        2 * std::numbers::pi * std::numbers::pi / (2.0 * height * height) * std::sin(place.y() * std::numbers::pi);
    sky.set(static_cast<int>(place.x() * 2 * height), static_cast<int>(place.y() * height),
            Color(6.5, 5.2, 3.6) * (0.4 / pixel));
    return sky;
}

std::shared_ptr<Light> evenlySampled(std::shared_ptr<Light> map) {
    return std::make_shared<EvenlySampled>(std::move(map));
}

}  // namespace caustic
