#include "measures/photon_pattern.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <opencv2/core.hpp>

#include "integrator/photon_tracer.h"
#include "light/cone_light.h"
#include "modeler/objects.h"
#include "sampling/emission_sampler.h"
#include "sampling/independent_sampler.h"

namespace caustic {

namespace {

constexpr Real halfAngle = 0.6;
const Real reach = std::tan(halfAngle);

Scene litFloor() {
    SceneDescription scene;
    scene.objects = {diffuseRectangle({-2, 0, -2}, {0, 0, 4}, {4, 0, 0}, Color::Constant(0.5))};
    scene.lights = {std::make_shared<ConeLight>(Vec3(0, 1, 0), -Vec3::UnitY(), halfAngle, Color::Ones())};
    return Scene(scene);
}

}  // namespace

PhotonPattern::PhotonPattern(const Sampler& sampler, int width, std::int64_t first, int threads)
    : width_(width), counts_(static_cast<std::size_t>(width * width), 0) {
    const Scene scene = litFloor();
    RayCounts counts;
    const PhotonSettings once = {.limits = {1, 1}};
    for (const Photon& photon :
         tracePhotons(scene, LightChoice(scene.lights()), sampler, once, first, photons, threads, counts)) {
        const auto pixel = [&](Real place) {
            return std::clamp(static_cast<int>((place / reach + 1) / 2 * width_), 0, width_ - 1);
        };
        ++counts_[static_cast<std::size_t>(pixel(photon.point.z()) * width_ + pixel(photon.point.x()))];
    }
}

// In the pixel's middle: of photons that are even over solid angle, cos³/h² of them are on an area.
Real PhotonPattern::expected(int x, int y) const {
    const Vec2 place = (Vec2(x + 0.5, y + 0.5) * 2 / width_ - Vec2::Ones()) * reach;
    if (place.norm() > reach * (1 - 2.0 / width_)) return 0;
    const Real cosine = 1 / std::sqrt(1 + place.squaredNorm());
    const Real area = std::pow(2 * reach / width_, 2);
    return static_cast<Real>(photons) * area * std::pow(cosine, 3) / (2 * std::numbers::pi * (1 - std::cos(halfAngle)));
}

Image PhotonPattern::picture() const {
    Image picture(width_, width_);
    for (int y = 0; y < width_; ++y) {
        for (int x = 0; x < width_; ++x) {
            const Real mean = expected(x, y);
            if (mean > 0) picture.set(x, y, Color::Constant(counts_[static_cast<std::size_t>(y * width_ + x)] / mean));
        }
    }
    return picture;
}

PhotonPattern::Spectrum PhotonPattern::spectrum() const {
    cv::Mat field(width_, width_, CV_64F);
    Real noise = 0;
    for (int y = 0; y < width_; ++y) {
        for (int x = 0; x < width_; ++x) {
            const Real r = ((Vec2(x + 0.5, y + 0.5) * 2 / width_ - Vec2::Ones())).squaredNorm();
            const Real window = r < 1 ? (1 - r) * (1 - r) : 0;
            const Real mean = expected(x, y);
            field.at<double>(y, x) = window * (mean > 0 ? counts_[static_cast<std::size_t>(y * width_ + x)] - mean : 0);
            // What photons without order bring: each pixel's count has its mean for a variance.
            noise += window * window * mean;
        }
    }
    cv::Mat waves;
    cv::dft(field, waves, cv::DFT_COMPLEX_OUTPUT);
    Spectrum spectrum;
    const int half = width_ / 2;
    std::vector<int> counts(static_cast<std::size_t>(half), 0);
    spectrum.power.assign(static_cast<std::size_t>(half), 0);
    int low = 0;
    for (int y = 0; y < width_; ++y) {
        for (int x = 0; x <= half; ++x) {
            const Real frequency = std::hypot(y <= half ? y : y - width_, x);
            const auto wave = waves.at<cv::Vec2d>(y, x);
            const Real power = (wave[0] * wave[0] + wave[1] * wave[1]) / noise;
            if (frequency < 1 || frequency >= half) continue;
            const auto ring = static_cast<std::size_t>(frequency);
            spectrum.power[ring] += power;
            ++counts[ring];
            if (frequency <= lowest) {
                spectrum.low += power;
                ++low;
            }
        }
    }
    spectrum.low /= low;
    for (std::size_t i = 1; i < counts.size(); ++i) spectrum.power[i] /= counts[i];
    spectrum.peak = *std::max_element(spectrum.power.begin() + 4, spectrum.power.end());
    return spectrum;
}

std::vector<Emission> emissions(std::uint64_t seed) {
    std::vector<Emission> all;
    all.push_back({"random", std::make_unique<IndependentSampler>(seed)});
    const auto add = [&](const std::string& name, CellPlace place) {
        all.push_back(
            {name, std::make_unique<EmissionSampler>(seed, PhotonPattern::columns, PhotonPattern::rows, place)});
    };
    add("plain grid", CellPlace::Centre);
    add("jittered grid", CellPlace::Jittered);
    add("grid with offsets", CellPlace::Offset);
    return all;
}

}  // namespace caustic
