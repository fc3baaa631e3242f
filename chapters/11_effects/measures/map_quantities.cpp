#include "measures/map_quantities.h"

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "camera/box_filter.h"
#include "camera/pinhole_camera.h"
#include "core/text.h"
#include "dented_ball.h"
#include "figure/timing.h"
#include "figures/picture.h"
#include "fluted_cup.h"
#include "image/laplacian.h"
#include "integrator/sppm.h"
#include "light/constant_environment.h"
#include "light/environment_map.h"
#include "maps.h"
#include "material/diffuse_material.h"
#include "measures/lens_estimates.h"
#include "measures/sky_estimates.h"
#include "sampling/sobol_sampler.h"
#include "shape/sphere.h"

namespace caustic {

namespace {

// A convex diffuse ball under an even map shows ρ L: the mean over paths, and its standard error.
void addEvenSky(CsvTable& table, FigureContext& context) {
    SceneDescription description;
    description.objects = {
        {std::make_shared<Sphere>(Vec3(0.3, -0.2, 0.1), 0.7), std::make_shared<DiffuseMaterial>(Color(0.6, 0.4, 0.2))}};
    description.lights = {std::make_shared<EnvironmentMap>(Image(16, 8, Color(1.5, 2, 0.5)))};
    description.camera =
        std::make_shared<PinholeCamera>(Vec3(4, 1, 2), Vec3(0.3, -0.2, 0.1), Vec3::UnitZ(), 0.1, 16, 16);
    const Image picture = tracedImage(Scene(description), context.byQuality(64, 1024), context);
    Real sum = 0;
    Real squares = 0;
    constexpr Real pixels = 256;
    for (int y = 0; y < 16; ++y) {
        for (int x = 0; x < 16; ++x) {
            const Real value = picture.at(x, y).x();
            sum += value / pixels;
            squares += value * value / pixels;
        }
    }
    table.addRow(
        "map of one colour", "radiance of a diffuse ball", sum, "W/(m2 sr)",
        "0.9 = rho L, standard error " + formatReal(std::sqrt(std::max(Real(0), squares - sum * sum) / pixels)));
}

// Variance times time of one sample, even directions over brightness.
void addBrightness(CsvTable& table, FigureContext& context) {
    constexpr int height = 64;
    const std::shared_ptr<const Light> map = environmentLight(sunnySky(height));
    const Vec3 normal = Vec3(-0.2, 0.1, 1).normalized();
    const Real truth = referenceIrradiance(*map, normal, height);
    const SkyChoice choices[] = {SkyChoice::Even, SkyChoice::Brightness};
    std::vector<Real> variances;
    std::vector<std::function<void()>> pieces;
    const int rounds = context.byQuality(100'000, 1'000'000);
    for (const SkyChoice choice : choices) {
        Real squares = 0;
        for (int i = 0; i < rounds; ++i) {
            Random random(context.seed(), {static_cast<std::uint64_t>(i)});
            const Real off = irradiance(*map, normal, choice, 1, random) - truth;
            squares += off * off / rounds;
        }
        variances.push_back(squares);
        pieces.push_back([&map, normal, choice] {
            Random random(1, {1});
            keep(irradiance(*map, normal, choice, 64, random));
        });
    }
    const auto nanoseconds = medianNanoseconds(pieces, {15, 1e-3});
    table.addRow("even directions", "sky with a sun: variance at equal samples", variances[0] / variances[1],
                 "times that by brightness", "1");
    table.addRow("even directions", "sky with a sun: variance at equal time",
                 variances[0] * nanoseconds[0] / (variances[1] * nanoseconds[1]), "times that by brightness",
                 "at least 20");
}

void addBlackPixels(CsvTable& table, FigureContext& context) {
    const auto count = [&](const std::string& method, Normals normals, Lookup lookup) {
        const Scene scene(dentedBall(normals, lookup, std::make_shared<ConstantEnvironment>(Color(0.5, 0.8, 1)), 200));
        const int black = blackPixels(tracedImage(scene, 4, context));
        table.addRow(method, "hammered mirror ball: black pixels", black, "pixels",
                     normals == Normals::Bare ? "more than 0" : "0");
    };
    count("smooth ball", Normals::Smooth, Lookup::Nearest);
    count("nearest, bent", Normals::Mapped, Lookup::Nearest);
    count("bilinear, bent", Normals::Mapped, Lookup::Bilinear);
    count("nearest, as it is", Normals::Bare, Lookup::Nearest);
    count("bilinear, as it is", Normals::Bare, Lookup::Bilinear);
}

// How uneven a caustic is from pixel to pixel: the root of the mean square of the Laplacian, over the mean. The noise
// of photons is left out: the Laplacians of two pictures with other photons are multiplied.
Real unevenness(const Image& first, const Image& second) {
    const Image a = laplacian(first);
    const Image b = laplacian(second);
    Real squares = 0;
    Real sum = 0;
    for (int y = 0; y < a.height(); ++y) {
        for (int x = 0; x < a.width(); ++x) {
            squares += a.at(x, y).y() * b.at(x, y).y();
            sum += (first.at(x, y).y() + second.at(x, y).y()) / 2;
        }
    }
    const Real pixels = Real(a.width()) * a.height();
    return std::sqrt(std::max(Real(0), squares / pixels)) / (sum / pixels);
}

void addCausticNoise(CsvTable& table, FigureContext& context) {
    const auto profile = context.asset("assets/profiles/teacup.svg");
    const auto add = [&](const std::string& method, std::optional<Lookup> lookup) {
        const Scene scene(flutedCupsCaustic(lookup, profile, 96));
        const auto picture = [&](std::uint64_t seed) {
            const SobolSampler sampler(seed);
            const BoxFilter filter;
            Sppm sppm(scene, sampler, filter,
                      {.limits = {.maxLength = 24}, .radius = 1.2e-3, .photons = context.byQuality(1 << 17, 1 << 18)});
            return renderImage(sppm, context.byQuality(4, 40), context);
        };
        table.addRow(method, "fluted cup: unevenness of its caustic", unevenness(picture(1), picture(2)),
                     "rms Laplacian over mean", "the smooth cup's");
    };
    add("smooth cup", std::nullopt);
    add("nearest normals", Lookup::Nearest);
    add("bilinear normals", Lookup::Bilinear);
}

void addConfusion(CsvTable& table, FigureContext& context) {
    const ThinLensCamera camera = measuringCamera();
    for (const Real depth : {2.0, 3.9, 7.0, 40.0}) {
        Random random(context.seed(), {7});
        const Real measured = measuredBlur(camera, depth, 64, true, random);
        table.addRow("thin lens", "blur's diameter at " + formatReal(depth) + " m, in focus at 4 m", measured, "pixels",
                     formatReal(camera.circleOfConfusion(depth)) + " = 2r|z - f|/(z f pixel)");
    }
}

}  // namespace

void addMapQuantities(CsvTable& table, FigureContext& context) {
    addEvenSky(table, context);
    addBrightness(table, context);
    addBlackPixels(table, context);
    addCausticNoise(table, context);
    addConfusion(table, context);
}

}  // namespace caustic
