#include "scenes.h"

#include <algorithm>
#include <cmath>

#include "camera/box_filter.h"
#include "camera/pinhole_camera.h"
#include "core/check.h"
#include "integrator/path_tracer.h"
#include "integrator/ray_tracer.h"
#include "integrator/sppm.h"
#include "light/cone_light.h"
#include "material/diffuse_material.h"
#include "material/refraction_material.h"
#include "medium/absorbing_medium.h"
#include "mesh/mesh_file.h"
#include "mesh/triangle_mesh.h"
#include "mesh/vertex_normals.h"
#include "modeler/objects.h"
#include "modeler/peers_box.h"
#include "modeler/wine_glass.h"
#include "shape/plane.h"

namespace caustic {

namespace {

const BoxFilter& boxFilter() {
    static const BoxFilter filter;
    return filter;
}

// As chapter 05 has it: glass that refracts all light, green inside, in a room of planes under a lamp.
SceneDescription glassBunny(const std::string& file, int width, int height) {
    MeshData mesh = loadMesh(file);
    if (mesh.normals.empty()) mesh = withVertexNormals(std::move(mesh), NormalWeight::Angle);
    const auto bunny = std::make_shared<TriangleMesh>(std::move(mesh));
    const Bounds3 box = bunny->bounds();
    const Real size = box.diagonal().norm() / 2;
    const Vec3 middle = box.center();
    const auto wall = [&](const Vec3& inSizes, const Vec3& normal, const Color& reflectance) {
        return SceneObject{.shape = std::make_shared<Plane>(middle + size * inSizes, normal),
                           .material = std::make_shared<DiffuseMaterial>(reflectance)};
    };
    const auto green = std::make_shared<AbsorbingMedium>(AbsorbingMedium::ofTransmittance(Color(0.2, 0.75, 0.3)));
    SceneDescription scene;
    scene.objects = {{.shape = bunny,
                      .material = std::make_shared<RefractionMaterial>(Color::Zero(), Color::Ones()),
                      .interior = Interior{1.5, green, 0}},
                     wall({0, (box.min().y() - middle.y()) / size - 1e-3, 0}, Vec3::UnitY(), Color::Constant(0.7)),
                     wall({0, 0, -6}, Vec3::UnitZ(), Color(0.62, 0.68, 0.75)),
                     wall({0, 0, 9}, -Vec3::UnitZ(), Color(0.75, 0.7, 0.62)),
                     wall({-7, 0, 0}, Vec3::UnitX(), Color(0.22, 0.45, 0.62)),
                     wall({7, 0, 0}, -Vec3::UnitX(), Color(0.7, 0.35, 0.18)),
                     wall({0, 6, 0}, -Vec3::UnitY(), Color::Constant(0.75)),
                     rectangleLamp(middle + size * Vec3(-1.5, 4, 0), size * Vec3(3, 0, 0), size * Vec3(0, 0, 3),
                                   Color::Constant(9))};
    scene.ambient = Color::Constant(0.35);
    scene.camera = std::make_shared<PinholeCamera>(
        middle + size * Vec3(0.6, 1.1, 3.9), middle - size * Vec3(0, 0.12, 0), Vec3::UnitY(), 0.55, width, height);
    return scene;
}

// Chapter 09's glass and wine from nearer by.
SceneDescription wineCup(const std::string& file, int width, int height) {
    SceneDescription scene;
    scene.objects = WineGlass{loadOutline(file)}.objects();
    scene.objects.push_back(diffuseRectangle({-1.6, -1e-4, -1}, {0, 0, 3}, {3.2, 0, 0}, Color(0.74, 0.7, 0.64)));
    scene.objects.push_back(diffuseRectangle({-1.6, -1e-4, -1}, {3.2, 0, 0}, {0, 1.6, 0}, Color(0.3, 0.36, 0.42)));
    scene.objects.push_back(rectangleLamp({-0.9, 0.1, 0.4}, {0, 0.9, 0}, {0.5, 0, 0.5}, Color(1.3, 1.5, 1.8)));
    const Vec3 lamp(-0.3, 0.56, -0.34);
    scene.lights = {std::make_shared<ConeLight>(lamp, Vec3(0.06, 0, 0.08) - lamp, 0.62, Color(1.7, 1.55, 1.3))};
    scene.camera = std::make_shared<PinholeCamera>(Vec3(0.12, 0.4, 0.8), Vec3(0.04, 0.075, 0.04), Vec3::UnitY(), 0.42,
                                                   width, height);
    return scene;
}

std::unique_ptr<Integrator> rayTracer(const Scene& scene, const Sampler& sampler) {
    return std::make_unique<RayTracer>(scene, sampler, boxFilter(),
                                       RayTracerSettings{.maxDepth = 10, .leastWeight = 1e-3, .shadowSamples = 2});
}

std::unique_ptr<Integrator> pathTracer(const Scene& scene, const Sampler& sampler) {
    return std::make_unique<PathTracer>(scene, sampler, boxFilter(),
                                        PathTracerSettings{{peersBoxSegments, 1}, Direct::Mis});
}

std::unique_ptr<Integrator> sppm(const Scene& scene, const Sampler& sampler) {
    SppmSettings settings;
    settings.limits.maxLength = 24;
    settings.radius = 6e-3;
    settings.photons = 1 << 15;
    return std::make_unique<Sppm>(scene, sampler, boxFilter(), settings);
}

}  // namespace

Scene Study::scene(const std::string& file, int width) const {
    return Scene(make(file, width, static_cast<int>(std::lround(aspect * width))));
}

const std::vector<Study>& studies() {
    static const std::vector<Study> all = {
        {"bunny", "bunny of glass", {1.7, 4}, 1, "assets/meshes/bunny.ply", glassBunny, rayTracer},
        {"box",
         "the peers' box",
         {1, 4},
         1,
         "",
         [](const std::string&, int width, int height) { return peersBox(width, height); },
         pathTracer},
        {"cup", "glass of wine", {1, 4}, 4.0 / 3, "assets/profiles/wine_glass.svg", wineCup, sppm}};
    return all;
}

std::vector<std::string> studyNames() {
    std::vector<std::string> names;
    for (const Study& one : studies()) names.push_back(one.name);
    return names;
}

const Study& study(const std::string& name) {
    const auto found = std::ranges::find(studies(), name, &Study::name);
    checkArgument(found != studies().end(), "scene", name, "must be bunny, box or cup");
    return *found;
}

std::string assetOf(const Study& study, FigureContext& context) {
    return study.asset.empty() ? "" : context.asset(study.asset).string();
}

}  // namespace caustic
