#include "final_scene.h"

#include <memory>
#include <numbers>
#include <utility>

#include "camera/thin_lens_camera.h"
#include "chosen_as.h"
#include "light/cone_light.h"
#include "light/constant_environment.h"
#include "light/environment_map.h"
#include "light/weighted_shape.h"
#include "maps.h"
#include "material/dielectric_material.h"
#include "material/phong_material.h"
#include "material/rough_conductor_material.h"
#include "medium/absorbing_medium.h"
#include "medium/henyey_greenstein.h"
#include "medium/homogeneous_medium.h"
#include "mesh/mesh_file.h"
#include "mesh/triangle_mesh.h"
#include "mesh/vertex_normals.h"
#include "modeler/objects.h"
#include "modeler/wine_glass.h"
#include "patterns.h"
#include "scene/normal_mapped_shape.h"
#include "shape/box.h"
#include "shape/instance.h"
#include "shape/rectangle.h"
#include "shape/sphere.h"
#include "teapot.h"
#include "texture/constant_texture.h"
#include "texture/image_texture.h"

namespace caustic {

namespace {

constexpr Real pi = std::numbers::pi;
constexpr Real clearance = 2e-4;  // between what stands on the table and the table: no two faces at one place
constexpr int fogPriority = -1;

std::shared_ptr<const Shape> dented(std::shared_ptr<const Shape> shape, const Image& heights,
                                    const Vec2& tiles = Vec2::Ones()) {
    return std::make_shared<NormalMappedShape>(
        std::move(shape), std::make_shared<NormalMap>(normalsOfHeights(heights), Lookup::Bilinear, tiles));
}

std::shared_ptr<const Shape> placed(std::shared_ptr<const Shape> shape, const Transform& toWorld) {
    return std::make_shared<Instance>(std::move(shape), toWorld);
}

void addTable(SceneDescription& scene, bool textured) {
    const auto top = std::make_shared<Rectangle>(Vec3(-1.5, 0, 0.9), Vec3(3, 0, 0), Vec3(0, 0, -1.65));
    std::shared_ptr<const Texture> wood = std::make_shared<ConstantTexture>(Color(0.2, 0.1, 0.045));
    if (textured) {
        wood = std::make_shared<ImageTexture>(std::make_shared<const Image>(woodPattern(2048, 1024, 7)),
                                              Lookup::Bilinear, Wrap::Repeat, Vec2(3, 4));
    }
    scene.objects.push_back({top, std::make_shared<PhongMaterial>(wood, Color::Constant(0.05), 90)});
}

void addGlassOfWine(SceneDescription& scene, bool normals, const FindAsset& asset) {
    const WineGlass glass = {loadOutline(asset("assets/profiles/wine_glass.svg").string())};
    const Transform place = Transform::translation({-0.13, clearance, 0.02});
    std::vector<SceneObject> parts = glass.objects();
    // Flutes around the lower half of the bowl: where u is between the stem and the widest part, outside.
    if (normals) parts.front().shape = dented(parts.front().shape, flutedPattern(512, 1536, 24, 0.47, 0.63, 0.25));
    for (SceneObject& one : parts) {
        one.shape = placed(one.shape, place);
        scene.objects.push_back(one);
    }
}

void addTeapot(SceneDescription& scene, bool normals, const FindAsset& asset) {
    std::shared_ptr<const Shape> pot = loadTeapot(asset("assets/teapot/teapot.txt"));
    constexpr Real scale = 0.052;
    const Transform upright = Transform::rotation(Vec3::UnitX(), -pi / 2);
    const Transform place = Transform::translation({0.09, clearance, -0.24}) *
                            Transform::rotation(Vec3::UnitY(), 0.45) * Transform::scaling(Vec3::Constant(scale)) *
                            upright;
    if (normals) pot = dented(pot, hammeredPattern(512, 5, 0.022, 3), Vec2(2, 1));
    scene.objects.push_back(
        {placed(pot, place), std::make_shared<RoughConductorMaterial>(Metal::copper(), 0.13, 0.13)});
}

void addBunny(SceneDescription& scene, const FindAsset& asset) {
    const auto bunny = std::make_shared<TriangleMesh>(
        withVertexNormals(loadMesh(asset("assets/meshes/bunny.ply")), NormalWeight::Angle));
    constexpr Real scale = 0.068;
    const Transform place = Transform::translation({0.15, clearance - scale * bunny->bounds().min().y(), 0.1}) *
                            Transform::rotation(Vec3::UnitY(), -0.35) * Transform::scaling(Vec3::Constant(scale));
    scene.objects.push_back({placed(bunny, place), std::make_shared<DielectricMaterial>(),
                             Interior{1.5, std::make_shared<AbsorbingMedium>(Color(22, 3, 16)), 0}});
}

void addMarbles(SceneDescription& scene) {
    const auto marble = [&](const Vec2& at, Real radius, const Color& sigmaA) {
        scene.objects.push_back({std::make_shared<Sphere>(Vec3(at.x(), radius + clearance, at.y()), radius),
                                 std::make_shared<DielectricMaterial>(),
                                 Interior{1.5, std::make_shared<AbsorbingMedium>(sigmaA), 0}});
    };
    marble({0.015, 0.17}, 0.014, Color(45, 18, 1));
    marble({-0.035, 0.235}, 0.012, Color(2, 30, 60));
    marble({0.30, -0.05}, 0.016, Color(3, 40, 22));
    marble({-0.26, 0.20}, 0.013, Color(1, 8, 50));
}

void addWindow(SceneDescription& scene, bool textured) {
    const Vec3 corner(-1.15, 0.08, 0.35);
    const auto pane = std::make_shared<Rectangle>(corner, Vec3(0.25, 0, -0.75), Vec3(0, 0.95, 0));
    constexpr Real radiance = 2.2;
    SceneObject window = {pane, nullptr, std::nullopt,
                          std::make_shared<ConstantTexture>(radiance * 0.65 * Color(0.93, 0.95, 1.05))};
    if (textured) {
        Image image = windowPattern(128, 192);
        for (float& value : image.data()) value *= static_cast<float>(radiance);
        window.shape = std::make_shared<WeightedShape>(pane, image, Wrap::Clamp);
        window.emission = std::make_shared<ImageTexture>(std::make_shared<const Image>(std::move(image)),
                                                         Lookup::Bilinear, Wrap::Clamp);
    }
    scene.objects.push_back(window);
}

void addSky(SceneDescription& scene, bool environment, const FindAsset& asset) {
    Image evening = loadPanorama(asset("assets/environments/esplanade.exr"));
    constexpr float dimmed = 0.35F;
    for (float& value : evening.data()) value *= dimmed;
    // Behind the table is the row of lamps, raised a little so that the picture has it above the table's edge.
    constexpr Real turn = 2.293;
    constexpr Real tilt = 0.11;
    const Transform raised = Transform::rotation(Vec3::UnitX(), -tilt);
    const Vec3 middle(std::cos(turn), 0, std::sin(turn));
    const Frame axes = {raised.vector(middle), raised.vector(Vec3::UnitY().cross(middle)),
                        raised.vector(Vec3::UnitY())};
    std::shared_ptr<Light> sky;
    if (environment) {
        sky = environmentLight(std::move(evening), axes);
    } else {
        sky = std::make_shared<ConstantEnvironment>(EnvironmentMap(std::move(evening)).mean());
    }
    scene.lights.push_back(std::make_shared<ChosenAs>(std::move(sky), 6));
}

}  // namespace

SceneDescription finalScene(const FinalParts& parts, const FindAsset& asset, int width, int height) {
    SceneDescription scene;
    addTable(scene, parts.textures);
    addGlassOfWine(scene, parts.normals, asset);
    addTeapot(scene, parts.normals, asset);
    addBunny(scene, asset);
    addMarbles(scene);
    addWindow(scene, parts.textures);
    addSky(scene, parts.environment, asset);
    const Vec3 spot(-0.42, 0.62, -0.5);
    const auto lamp = std::make_shared<ConeLight>(spot, Vec3(-0.02, 0.04, 0.02) - spot, 0.3, Color(3.0, 2.7, 2.25));
    scene.lights.push_back(std::make_shared<ChosenAs>(lamp, 4));
    if (parts.fog) {
        const auto haze = std::make_shared<HomogeneousMedium>(Color::Zero(), Color::Constant(0.06),
                                                              std::make_shared<HenyeyGreenstein>(0.6));
        scene.objects.push_back({std::make_shared<Box>(Vec3(-0.62, 0.002, -0.62), Vec3(0.13, 0.7, 0.15)), nullptr,
                                 Interior{1, haze, fogPriority}});
    }
    const Vec3 eye(0.02, 0.25, 1.0);
    const Vec3 target(0.02, 0.088, 0);
    scene.camera = std::make_shared<ThinLensCamera>(eye, target, Vec3::UnitY(), 0.325, width, height,
                                                    parts.lens ? 0.006 : 0, (Vec3(0, 0.08, 0.04) - eye).norm());
    return scene;
}

}  // namespace caustic
