#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "camera/box_filter.h"
#include "camera/pinhole_camera.h"
#include "integrator/render.h"
#include "integrator/sppm.h"
#include "light/cone_light.h"
#include "material/diffuse_material.h"
#include "material/mirror_material.h"
#include "modeler/objects.h"
#include "sampling/sobol_sampler.h"
#include "shape/plane.h"

namespace caustic {
namespace {

constexpr Real pi = std::numbers::pi;
const Color tint(0.9, 0.4, 0.7);

enum class Lit { Straight, OverMirror, Both };

// A diffuse floor, and a mirror that stands on it, x = 1. One spotlight shines straight on the place that the camera
// looks at, the other one over the mirror: as if it stood behind it. The camera sees the place straight, or over the
// mirror, too.
struct MirrorFloor {
    bool seenInMirror = false;
    Lit lit = Lit::OverMirror;
    int width = 6;
    int height = 6;
    Real fieldOfView = 0.01;
    Real spread = 0.08;  // of the spotlights
    Color floor = {0.8, 0.5, 0.2};
    Color intensity = {10, 20, 15};
    Vec3 lamp = {-0.5, 1.5, 0.3};
    Vec3 other = {-0.3, 1.6, -0.4};
    Vec3 target = {0.1, 0, 0.2};

    static Vec3 mirrored(const Vec3& place) { return {2 - place.x(), place.y(), place.z()}; }

    SceneDescription scene() const {
        SceneDescription scene;
        scene.objects = {diffuseRectangle({-3, 0, -3}, {0, 0, 6}, {4, 0, 0}, floor),
                         {std::make_shared<Plane>(Vec3(1, 0, 0), -Vec3::UnitX()),
                          std::make_shared<MirrorMaterial>(tint),
                          {},
                          nullptr}};
        const auto spot = [&](const Vec3& place, const Vec3& towards) {
            scene.lights.push_back(std::make_shared<ConeLight>(place, towards - place, spread, intensity));
        };
        if (lit != Lit::OverMirror) spot(lamp, target);
        if (lit != Lit::Straight) spot(other, mirrored(target));
        scene.camera = std::make_shared<PinholeCamera>(Vec3(-1, 0.8, 0.1), seenInMirror ? mirrored(target) : target,
                                                       Vec3::UnitY(), fieldOfView, width, height);
        return scene;
    }

    // The shortest paths that bring photons: no others are as short.
    int segments() const { return seenInMirror ? 4 : 3; }

    Color from(const Vec3& place) const {
        const Vec3 way = place - target;
        return floor / pi * intensity * (way.y() / std::pow(way.norm(), 3));
    }
    Color seen() const { return seenInMirror ? tint : Color::Ones(); }
    // What the pixels should be.
    Color all() const {
        Color sum = Color::Zero();
        if (lit != Lit::OverMirror) sum += seen() * from(lamp);
        if (lit != Lit::Straight) sum += seen() * tint * from(mirrored(other));
        return sum;
    }
};

// All pixels look at one place, and the spot that the mirror throws lies within the discs of early passes: whatever is
// seen is known to the last digits.
MirrorFloor pointed(bool seenInMirror = false) {
    return {.seenInMirror = seenInMirror, .width = 13, .height = 5, .fieldOfView = 1e-9, .spread = 0.005};
}

// All of the spot's power is scattered evenly: radiance times area.
Color fluxOf(const MirrorFloor& what) {
    const Real solidAngle = 4 * pi * std::pow(std::sin(what.spread / 2), 2);
    return what.seen() * what.floor / pi * tint * what.intensity * solidAngle;
}

// How far the pixel is off that is off most, relatively.
Real farthestOff(const Film& film, const Color& expected) {
    Real most = 0;
    for (int y = 0; y < film.height(); ++y) {
        for (int x = 0; x < film.width(); ++x)
            most = std::max(most, (film.value({x, y}) / expected - 1).abs().maxCoeff());
    }
    return most;
}

Color meanOf(const Image& picture) {
    Color sum = Color::Zero();
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) sum += picture.at(x, y);
    }
    return sum / (picture.width() * picture.height());
}

SppmSettings settings(RadiusRule rule, int mostSegments, int photons) {
    SppmSettings settings;
    settings.limits = {.maxLength = mostSegments, .rouletteStart = 0};
    settings.rule = rule;
    settings.radius = 0.1;
    settings.photons = photons;
    return settings;
}

// Without roulette no chance is left in what is known to the last digits.
SppmSettings withoutRoulette(RadiusRule rule, int mostSegments) {
    SppmSettings all = settings(rule, mostSegments, 500);
    all.limits.rouletteStart = mostSegments;
    return all;
}

Film exactly(const MirrorFloor& what, int mostSegments) {
    const Scene scene(what.scene());
    const SobolSampler sampler(2);
    const BoxFilter filter;
    Sppm sppm(scene, sampler, filter, withoutRoulette(RadiusRule::Pass, mostSegments));
    return render(sppm, {.passes = 1}).film;
}

Image rendered(const MirrorFloor& what, const SppmSettings& settings, std::int64_t passes, std::uint64_t seed = 1) {
    const Scene scene(what.scene());
    const SobolSampler sampler(seed);
    const BoxFilter filter;
    Sppm sppm(scene, sampler, filter, settings);
    const Rendering rendering = render(sppm, {.passes = passes});
    return developed(sppm, rendering);
}

// What comes straight from the lamp is sampled at the point, seen straight and over the mirror; photons bring nothing.
TEST(SppmLook, SamplesDirectLightAtThePoint) {
    for (const bool mirror : {false, true}) {
        const MirrorFloor what = {.seenInMirror = mirror, .lit = Lit::Straight};
        const Color found = meanOf(rendered(what, settings(RadiusRule::Pass, mirror ? 3 : 2, 100), 1));
        EXPECT_LE((found / what.all() - 1).abs().maxCoeff(), 0.025)
            << "Direct light at the visible point, times the throughput of the path that sees it?";
        EXPECT_LE(meanOf(rendered(what, settings(RadiusRule::Pass, mirror ? 2 : 1, 100), 1)).maxCoeff(), 0)
            << "The way to the lamp is a segment, too.";
        MirrorFloor exact = pointed(mirror);
        exact.lit = Lit::Straight;
        EXPECT_LE(farthestOff(exactly(exact, mirror ? 3 : 2), exact.all()), 1e-8)
            << "Direct light at the visible point, times the throughput of the path that sees it?";
    }
}

// Seen over the mirror, photons count times what the mirror leaves, as everything else does: the ratio of the two
// pictures, channel by channel. Some 2,000 photons in each of the discs.
TEST(SppmLook, ScalesWhatPhotonsBring) {
    const auto found = [](const MirrorFloor& what) -> Color {
        return meanOf(rendered(what, settings(RadiusRule::Pass, what.segments(), 2000), 16));
    };
    EXPECT_LE((found({.seenInMirror = true}) / found({}) / tint - 1).abs().maxCoeff(), 0.15)
        << "What has the mirror left of the path's throughput?";
    const MirrorFloor exact = pointed(true);
    EXPECT_LE(farthestOff(exactly(exact, 4), fluxOf(exact) / (pi * 0.01)), 1e-8)
        << "What has the mirror left of the path's throughput?";
}

// What comes over the mirror is brought by photons alone: about 19,000 within the discs of 24 passes, so that their
// mean is off by 0.7 %.
TEST(SppmPass, AddsWhatPhotonsBring) {
    const MirrorFloor what;
    const Color found = meanOf(rendered(what, settings(RadiusRule::Pass, what.segments(), 10'000), 24));
    EXPECT_LE((found / what.all() - 1).abs().maxCoeff(), 0.035)
        << "Flux over the area of the disc that it was found in?";

    // R² of pass i is that of the first one times (k + α)/(k + 1), k = 1 to i.
    const MirrorFloor exact = pointed();
    const Scene scene(exact.scene());
    const SobolSampler sampler(3);
    const BoxFilter filter;
    Sppm sppm(scene, sampler, filter, withoutRoulette(RadiusRule::Pass, 3));
    Real squared = 0.01;
    for (int pass = 0; pass < 8; ++pass) {
        if (pass > 0) squared *= (pass + 2.0 / 3) / (pass + 1);
        const std::vector<PathId> paths = pathsOfAllPixels(scene.camera(), pass);
        const Rendering rendering = sppm.runPass({pass, paths}, 1 + pass % 3);
        EXPECT_LE(farthestOff(rendering.film, fluxOf(exact) / (pi * squared)), 1e-8)
            << "pass " << pass << ": Flux over the area of the disc that it was found in?";
        EXPECT_EQ(rendering.passes, 1);
        EXPECT_EQ(rendering.seconds, 0) << "Who runs passes measures their time.";
        EXPECT_EQ(rendering.counts.rays, 2 * 500 + 65) << "Photons' segments and eye paths: are all of them counted?";
    }
}

// By rule ② the photons' part comes from the statistics of each pixel, and the rest from the film: 32 passes ask each
// of the two lamps 16 times.
TEST(SppmPass, KeepsStatisticsOfEachPixel) {
    const MirrorFloor what = {.lit = Lit::Both};
    const Scene scene(what.scene());
    const SobolSampler sampler(1);
    const BoxFilter filter;
    Sppm sppm(scene, sampler, filter, settings(RadiusRule::Point, what.segments(), 16'000));
    const Rendering rendering = render(sppm, {.passes = 32});
    const Color found = meanOf(developed(sppm, rendering));
    EXPECT_LE((found / what.all() - 1).abs().maxCoeff(), 0.035)
        << "Is the photons' part there once, and the rest, too?";
    for (int x = 0; x < what.width; ++x) {
        EXPECT_LT(sppm.statistics({x, x}).radius, 0.1) << "Photons make the radius smaller.";
        EXPECT_GT(sppm.statistics({x, x}).photons, 0);
    }

    // Each pass finds all 500 photons in each pixel's disc.
    const MirrorFloor exact = pointed();
    const Scene narrow(exact.scene());
    Sppm known(narrow, sampler, filter, withoutRoulette(RadiusRule::Point, 3));
    PointStatistics expected = {0.1, 0, Color::Zero()};
    for (int pass = 0; pass < 5; ++pass) {
        const std::vector<PathId> paths = pathsOfAllPixels(narrow.camera(), pass);
        const Film film = known.runPass({pass, paths}, 2).film;
        EXPECT_LE(meanOf(film.image()).maxCoeff(), 0) << "Here photons go into the statistics, and not onto the film.";
        const Real n = expected.photons + 2.0 / 3 * 500;
        const Real share = n / (expected.photons + 500);
        expected = {expected.radius * std::sqrt(share), n, (expected.flux + fluxOf(exact)) * share};
        for (int x = 0; x < exact.width; ++x) {
            const PointStatistics& one = known.statistics({x, x % 5});
            EXPECT_NEAR(one.radius / expected.radius, 1, 1e-9);
            EXPECT_NEAR(one.photons / expected.photons, 1, 1e-9);
            EXPECT_LE((one.flux / expected.flux - 1).abs().maxCoeff(), 1e-8)
                << "Which photons, and within which radius?";
        }
    }
}

// New photons in every pass, within the radius of the pass: the same paths see others, and fewer and fewer of them.
TEST(SppmPass, TracesNewPhotonsWithinASmallerRadius) {
    const MirrorFloor what = {.width = 8, .height = 8};
    const Scene scene(what.scene());
    const SobolSampler sampler(1);
    const BoxFilter filter;
    Sppm sppm(scene, sampler, filter, settings(RadiusRule::Pass, what.segments(), 2000));
    const std::vector<PathId> paths = pathsOfAllPixels(scene.camera(), 0);
    const auto pass = [&](std::int64_t number, int threads) -> Color {
        return sppm.runPass({number, paths}, threads).film.image().at(3, 3);
    };
    // How far passes are off, root mean square: all have the same paths, so it is the photons within the disc.
    const auto deviation = [&](std::int64_t number) {
        Real sum = 0;
        for (int i = 0; i < 24; ++i) sum += (pass(number + i, 1) / what.all() - 1).square().mean();
        return std::sqrt(sum / 24);
    };
    EXPECT_FALSE((pass(0, 1) == pass(1, 1)).all()) << "Are the photons new ones?";
    // R² of pass 10,000 is 1/19 of the first: about four times the deviation.
    EXPECT_GT(deviation(10'000), 2 * deviation(0)) << "Which radius has the pass of that number?";
    EXPECT_TRUE((pass(0, 1) == pass(0, 2)).all()) << "The same pass, the same picture, by any threads.";
}

}  // namespace
}  // namespace caustic
