#include "light/environment_map.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "image/spherical_map.h"
#include "light/constant_environment.h"
#include "math/spawn.h"
#include "sampling/warp.h"

namespace caustic {

namespace {

constexpr Real pi = std::numbers::pi;

// How much of the sphere lies above a row, by y / height: (1 − cos θ)/2.
Real heightOf(Real v) {
    const Real sine = std::sin(v * pi / 2);
    return sine * sine;
}

// The same of a direction in the panorama's axes, without a difference of nearly equal numbers.
Real heightOf(const Vec3& local) {
    const Real aside = local.x() * local.x() + local.y() * local.y();
    return local.z() > 0 ? aside / (2 * (1 + local.z())) : 1 - aside / (2 * (1 - local.z()));
}

// ∫ w(θ) sin θ dθ over a row's weight w in the bilinear look-up, which rises and falls from centre to centre and is 1
// between a pole and the centre next to it. All rows together have 2.
Real shareOfRow(int row, int rows) {
    if (rows == 1) return 2;
    const Real step = pi / rows;
    const Real theta = (row + Real(0.5)) * step;
    if (row == 0 || row == rows - 1) return 1 - (std::sin(1.5 * step) - std::sin(0.5 * step)) / step;
    return 2 * std::sin(theta) * (1 - std::cos(step)) / step;
}

Color meanOverSphere(const Image& image) {
    Color sum = Color::Zero();
    for (int y = 0; y < image.height(); ++y) {
        Color row = Color::Zero();
        for (int x = 0; x < image.width(); ++x) row += image.at(x, y);
        sum += row * shareOfRow(y, image.height());
    }
    return sum / (2 * image.width());
}

}  // namespace

EnvironmentMap::EnvironmentMap(Image radiance, const Frame& axes)
    : radiance_(std::move(radiance)),
      axes_(axes),
      distribution_(radiance_, Wrap::Repeat, Wrap::Clamp, [](Real v) { return heightOf(v); }),
      mean_(meanOverSphere(radiance_)) {}

void EnvironmentMap::prepare(const Bounds3& scene) {
    if (scene.isEmpty()) return;
    center_ = scene.center();
    radius_ = scene.diagonal().norm() / 2;
}

EnvironmentMap::Direction EnvironmentMap::sampleDirection(const Vec2& u) const {
    const ImageDistribution::Sample place = distribution_.sample(u);
    const Real azimuth = (Real(0.5) - place.at.x()) * 2 * pi;
    const Real h = std::clamp(place.at.y(), Real(0), Real(1));
    const Real sine = 2 * std::sqrt(h * (1 - h));
    const Vec3 local(sine * std::cos(azimuth), sine * std::sin(azimuth), 1 - 2 * h);
    // PBR, 4th ed., 12.5.2, for places by area: the unit square is the whole sphere, 4π.
    return {axes_.toWorld(local), place.pdf / (4 * pi)};
}

Real EnvironmentMap::pdfW(const Vec3& direction) const {
    const Vec3 local = axes_.toLocal(direction);
    // As in sampleDirection.
    return distribution_.pdf({sphericalToUv(local).x(), heightOf(local)}) / (4 * pi);
}

Color EnvironmentMap::radianceFrom(const Vec3& direction) const {
    return lookUpSpherical(radiance_, axes_.toLocal(direction));
}

std::optional<DirectSample> EnvironmentMap::sampleDirect(const SurfacePoint& from, const Vec2& u) const {
    const Direction one = sampleDirection(u);
    return DirectSample{one.to, radianceFrom(one.to), one.pdfW, spawnRay(from, one.to), {}};
}

Real EnvironmentMap::pdfW(const Vec3&, const Vec3& wi) const { return pdfW(wi); }

std::optional<EmissionSample> EnvironmentMap::sampleEmission(const Vec2& uPlace, const Vec2& uDirection) const {
    const Direction one = sampleDirection(uDirection);
    const Vec3 direction = -one.to;
    const Frame frame = Frame::around(direction);
    const Vec2 disc = radius_ * concentricDisc(uPlace);
    const Vec3 origin = center_ - radius_ * direction + disc.x() * frame.s + disc.y() * frame.t;
    // PBR, 4th ed., 12.5.2: uniform over the disc that the scene shows in this direction.
    return EmissionSample{{origin, direction}, direction, radianceFrom(one.to), 1 / (pi * radius_ * radius_), one.pdfW};
}

EmissionPdf EnvironmentMap::pdfEmission(const SurfacePoint&, const Vec3& direction) const {
    // As in sampleEmission.
    return {1 / (pi * radius_ * radius_), pdfW(-direction)};
}

Color EnvironmentMap::Le(const Ray& escaped) const { return radianceFrom(escaped.direction); }

Color EnvironmentMap::power() const { return 4 * pi * pi * radius_ * radius_ * mean_; }

std::shared_ptr<Light> environmentLight(Image radiance, const Frame& axes) {
    const Color first = radiance.at(0, 0);
    const auto values = radiance.data();
    bool same = true;
    for (std::size_t i = 3; i < values.size(); ++i) same = same && values[i] == values[i - 3];
    if (same) return std::make_shared<ConstantEnvironment>(first);
    return std::make_shared<EnvironmentMap>(std::move(radiance), axes);
}

}  // namespace caustic
