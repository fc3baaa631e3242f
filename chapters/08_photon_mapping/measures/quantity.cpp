#include <cmath>
#include <numbers>

#include "camera/box_filter.h"
#include "core/random.h"
#include "core/thread_clock.h"
#include "figure/quantities.h"
#include "figures.h"
#include "image/picture_error.h"
#include "integrator/ray_count_rows.h"
#include "integrator/render.h"
#include "light/point_light.h"
#include "material/diffuse_material.h"
#include "material/mirror_material.h"
#include "measures/blurred_edge.h"
#include "measures/floor_caustic.h"
#include "modeler/diffuse_box.h"
#include "modeler/objects.h"
#include "modeler/peers_box.h"
#include "sampling/independent_sampler.h"
#include "shape/box.h"
#include "textbook_density.h"

namespace caustic {

namespace {

constexpr Real pi = std::numbers::pi;

// All bounces in a closed room of one colour bring Φ/(1 − ρ) to its walls.
void addPower(CsvTable& table, FigureContext& context) {
    const Color rho(0.7, 0.3, 0.5);
    const Color intensity(4, 0.7, 2);
    SceneObject walls = {
        std::make_shared<Box>(Vec3(5, -3, 2), Vec3(7.3, -2, 3.4)), std::make_shared<DiffuseMaterial>(rho), {}, nullptr};
    const Scene scene(
        {{walls}, {std::make_shared<PointLight>(Vec3(5.4, -2.3, 3.1), intensity)}, Color::Zero(), nullptr});
    const IndependentSampler sampler(context.seed());
    const Color expected = 4 * pi * intensity / (1 - rho);
    const auto add = [&](const std::string& name, const PathLimits& limits) {
        RayCounts counts;
        Color sum = Color::Zero();
        for (const Photon& photon : tracePhotons(scene, LightChoice(scene.lights()), sampler, {limits}, 0,
                                                 context.byQuality(20'000, 1'000'000), context.threads(), counts))
            sum += photon.power;
        table.addRow(name, "photons' power in a closed room", 100 * (sum / expected - 1).abs().maxCoeff(), "% off",
                     "power/(1 - reflectance), the worst of three colours");
    };
    add("roulette from the first wall on", {400, 0});
    add("roulette from the twentieth wall on", {400, 20});
}

// What k photons on an evenly lit plane say of its irradiance, on average.
void addRadiusRules(CsvTable& table, FigureContext& context) {
    const Scene scene(
        {{diffuseRectangle({-9, -9, 0}, {18, 0, 0}, {0, 18, 0}, Color::Constant(0.5))}, {}, Color::Zero(), nullptr});
    MediumStack media;
    Color passed;
    RayCounts counts;
    const Interaction at = *scene.follow({Vec3(0, 0, 1), -Vec3::UnitZ()}, media, passed, counts);
    const int maps = context.byQuality(2'000, 20'000);
    constexpr std::size_t photons = 300;  // on 2 m × 2 m
    const Real truth = 0.5 / pi * photons / 4;
    for (const int k : {2, 5, 20, 50}) {
        Real textbook = 0;
        Real ours = 0;
        for (int i = 0; i < maps; ++i) {
            Random random(context.seed(), {static_cast<std::uint64_t>(i)});
            std::vector<Photon> lying;
            for (std::size_t j = 0; j < photons; ++j)
                lying.push_back({Vec3(random.uniform(-1, 1), random.uniform(-1, 1), 0), Vec3::UnitZ(), Color::Ones(),
                                 Vec3::UnitZ(), 1, PhotonWay::Direct});
            const PhotonMap map(lying);
            textbook += textbookRadiance(map, at, k, 9).x() / maps;
            ours += map.radiance(at, {.nearest = k, .radius = 9}).x() / maps;
        }
        const std::string name = "mean of an even density by " + std::to_string(k) + " photons";
        table.addRow("radius of the k-th photon", name, textbook / truth, "of the truth",
                     "k/(k - 1) = " + formatReal(static_cast<Real>(k) / (k - 1)));
        table.addRow("radius of the photon behind", name, ours / truth, "of the truth", "1");
    }
}

// What roulette and splitting cost and bring.
void addSplitting(CsvTable& table, FigureContext& context) {
    const FloorCaustic floor(context);
    for (const int splits : {0, 3}) {
        PhotonMapperSettings settings = {.photons = context.byQuality(10'000, 100'000), .limits = {64, 1}};
        settings.splits = splits;
        settings.density = {.nearest = {}, .radius = 0.03};
        settings.caustics = settings.density;
        Real squares = 0;
        double seconds = 0;
        constexpr int maps = 4;
        for (std::uint64_t i = 0; i < maps; ++i) {
            const FloorCaustic::Taken taken = floor.byPhotons(settings, 4, context.seed() + i);
            const Real error = rmse(taken.picture, floor.reference());
            squares += error * error / maps;
            seconds += taken.seconds / maps;
        }
        const IndependentSampler sampler(context.seed());
        const BoxFilter filter;
        const PhotonMapper mapper(floor.scene(), sampler, filter, settings, context.threads());
        const std::string name = splits == 0 ? "roulette" : "split at the first three surfaces";
        table.addRow(name, "caustic: error with the same number of photons", std::sqrt(squares), "radiance (rms)", "");
        table.addRow(name, "caustic: photons in the map", static_cast<Real>(mapper.caustics().size()), "photons", "");
    }
}

// How wide a sharp border of light becomes.
void addBlur(CsvTable& table, FigureContext& context) {
    for (const Real radius : {0.02, 0.05, 0.1})
        table.addRow("photons within the radius", "width of a sharp border, radius " + formatReal(radius) + " m",
                     blurredEdgeWidth(radius, context.byQuality(20'000, 200'000), context.seed()),
                     "m, from 10 % to 90 %", "closed form: " + formatReal(blurredEdgeWidth(radius)));
}

// What isn't done where a scene doesn't need it.
void addNeeds(CsvTable& table, FigureContext& context) {
    const IndependentSampler sampler(context.seed());
    const BoxFilter filter;
    const auto add = [&](const std::string& name, const SceneDescription& description) {
        const Scene scene(description);
        PhotonMapper mapper(scene, sampler, filter, {.photons = 1000}, context.threads());
        table.addRow("photon mapping", name + ": photons in the caustic map",
                     static_cast<Real>(mapper.caustics().size()), "photons", "");
        addRayCounts(table, "photon mapping", name + ": ", mapper.photonCounts(), 1000);
    };
    add("diffuse box", DiffuseBox{}.scene(32, 32));
    add("peers' box", peersBox(32, 32));
    SceneDescription mirrors = DiffuseBox{}.scene(32, 32);
    for (SceneObject& object : mirrors.objects) {
        if (object.material != nullptr) object.material = std::make_shared<MirrorMaterial>(Color::Constant(0.8));
    }
    add("box of mirrors", mirrors);
}

}  // namespace

void tabulateQuantities(FigureContext& context) {
    writeQuantities(
        {[&](CsvTable& table) { addPower(table, context); }, [&](CsvTable& table) { addRadiusRules(table, context); },
         [&](CsvTable& table) { addSplitting(table, context); }, [&](CsvTable& table) { addBlur(table, context); },
         [&](CsvTable& table) { addNeeds(table, context); }},
        context);
}

}  // namespace caustic
