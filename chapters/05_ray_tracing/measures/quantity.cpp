#include <cmath>
#include <memory>
#include <numbers>
#include <string>

#include "camera/box_filter.h"
#include "core/random.h"
#include "figure/quantities.h"
#include "figures.h"
#include "integrator/ray_count_rows.h"
#include "integrator/ray_tracer.h"
#include "integrator/render.h"
#include "light/point_light.h"
#include "material/diffuse_material.h"
#include "math/spawn.h"
#include "sampling/stratified_sampler.h"
#include "scenes.h"
#include "shape/plane.h"
#include "shape/sphere.h"
#include "slab.h"

namespace caustic {

namespace {

constexpr Real pi = std::numbers::pi;
const Vec3 lampPlace(0, 4, 0);

// A point light of 1 W/sr above a glass ball above a white floor.
Scene causticScene() {
    SceneDescription scene;
    scene.objects = {{.shape = std::make_shared<Plane>(Vec3::Zero(), Vec3::UnitY()),
                      .material = std::make_shared<DiffuseMaterial>(Color::Ones())},
                     {.shape = std::make_shared<Sphere>(Vec3(0, 1.2, 0), 1.0),
                      .material = clearGlass(),
                      .interior = Interior{1.5, nullptr, 0}}};
    scene.lights = {std::make_shared<PointLight>(lampPlace, Color::Ones())};
    return Scene(scene);
}

// The flux that arrives on a disc of radius 4 of the floor, W: by rays that follow the light, however it is bent.
Real fluxByEmission(const Scene& scene, std::int64_t rays, std::uint64_t seed) {
    Real flux = 0;
    for (std::int64_t i = 0; i < rays; ++i) {
        Random random(seed, {static_cast<std::uint64_t>(i)});
        const Real x = random.uniform();
        const auto light = scene.lights()[0]->sampleEmission({0, 0}, {x, random.uniform()});
        Ray ray = light->ray;
        MediumStack media;
        RayCounts counts;
        Color passed;
        for (int depth = 0; depth < 8; ++depth) {
            const auto at = scene.follow(ray, media, passed, counts);
            if (!at) break;
            if (!anyOf(at->bsdf()->lobes(), LobeFlags::Delta)) {
                if (at->hit().point.norm() <= 4) flux += light->radiance.x() / light->pdfW;
                break;
            }
            const BsdfSample lobe = at->bsdf()->deltaLobes(at->wo(), TransportMode::Importance).lobe[0];
            media = at->media(lobe.wi);
            ray = spawnRay(at->hit(), lobe.wi);
        }
    }
    return flux / static_cast<Real>(rays);
}

// The same as ray tracing sees it: straight from the light or not at all. Irradiance over rings of equal area.
Real fluxByRayTracing(const Scene& scene, int rings) {
    const StratifiedSampler sampler(1, 1);
    const BoxFilter filter;
    const RayTracer tracer(scene, sampler, filter, {.maxDepth = 0});
    RayCounts counts;
    Real flux = 0;
    for (int i = 0; i < rings; ++i) {
        const Real r = 4 * std::sqrt((i + 0.5) / rings);
        const Ray ray = {Vec3(r, 1e-3, 0), -Vec3::UnitY()};
        flux += pi * tracer.Li(ray, {}, sampler.start(0, {0, 0}, i), counts).x() * 16 * pi / rings;
    }
    return flux;
}

void addShadowOfGlass(CsvTable& table, FigureContext& context) {
    const Scene scene = causticScene();
    const Real truth = fluxByEmission(scene, 400'000, context.seed());
    const Real seen = fluxByRayTracing(scene, 20'000);
    table.addRow("ray tracing", "light that a glass ball's shadow lacks", 100 * (truth - seen) / truth,
                 "percent of the floor's light", "rays from the lamp, bent at the ball");
    const Real blocked = pi * 2 * (1 - std::sqrt(1 - 1 / (2.8 * 2.8)));
    table.addRow("closed form", "light that meets the ball", 100 * blocked / truth, "percent of the floor's light",
                 "solid angle of the ball");
}

void addPanes(CsvTable& table) {
    for (const Real reflectance : {0.04, 0.5, 0.9}) {
        const Scene slab(slabScene(reflectance, 0));
        const StratifiedSampler sampler(1, 1);
        const BoxFilter filter;
        const RayTracer tracer(slab, sampler, filter, {.maxDepth = 1000, .leastWeight = 1e-9});
        RayCounts counts;
        const Real through = tracer.Li({Vec3(-1, 0, 0), Vec3::UnitX()}, {}, sampler.start(0, {0, 0}, 0), counts).x();
        table.addRow("ray tracing",
                     "pane that reflects " + formatReal(100 * reflectance) + " percent: light let through", through,
                     "share", formatReal(slabTransmission(reflectance, 0)) + " = (1 - R) / (1 + R)");
    }
}

void addCounts(CsvTable& table, FigureContext& context) {
    SceneDescription plain = emptyRoom();
    plain.objects.erase(plain.objects.begin());  // the checkered floor
    plain.objects.push_back(ballOnFloor(std::make_shared<DiffuseMaterial>(Color::Constant(0.5))));
    plain.lights = {std::make_shared<PointLight>(Vec3(0, 3, 1), Color::Ones())};
    plain.camera = roomCamera(64, 48);
    const StratifiedSampler sampler(context.seed(), 1);
    const BoxFilter filter;
    for (const bool rich : {false, true}) {
        const Scene scene(rich ? boxScene(64, 48) : plain);
        RayTracer tracer(scene, sampler, filter, {.maxDepth = 8, .shadowSamples = 4});
        const RayCounts counts = render(tracer, {.passes = 1, .threads = context.threads()}).counts;
        const std::string where = rich ? "box with mirror, glass and lamp: " : "diffuse room with a point light: ";
        addRayCounts(table, "ray tracing", where, counts, 64 * 48);
    }
}

}  // namespace

void tabulateQuantities(FigureContext& context) {
    writeQuantities({[&](CsvTable& table) { addShadowOfGlass(table, context); }, addPanes,
                     [&](CsvTable& table) { addCounts(table, context); }},
                    context);
}

}  // namespace caustic
