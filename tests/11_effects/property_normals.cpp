#include <gtest/gtest.h>

#include <cmath>

#include "camera/box_filter.h"
#include "camera/pinhole_camera.h"
#include "core/error.h"
#include "core/random.h"
#include "integrator/path_tracer.h"
#include "integrator/render.h"
#include "integrator/sppm.h"
#include "light/constant_environment.h"
#include "material/dielectric_material.h"
#include "material/diffuse_material.h"
#include "material/mirror_material.h"
#include "material/rough_conductor_material.h"
#include "sampling/independent_sampler.h"
#include "scene/normal_mapped_shape.h"
#include "shape/instance.h"
#include "shape/sphere.h"
#include "test_maps.h"

namespace caustic {
namespace {

const IndependentSampler sampler(5);
const BoxFilter filter;

// Dents all over, as steep as 60 degrees, or flatter.
Image roughNormals(std::uint64_t seed, Real slope = 1.2) {
    Random random(seed, {9});
    Image normals(32, 16);
    for (int y = 0; y < 16; ++y) {
        for (int x = 0; x < 32; ++x)
            normals.set(x, y, Color(random.uniform(-slope, slope), random.uniform(-slope, slope), 1));
    }
    return normals;
}

SceneDescription ballScene(const std::shared_ptr<const Shape>& shape, std::shared_ptr<const Material> material,
                           std::optional<Interior> interior = std::nullopt) {
    SceneDescription scene;
    scene.objects = {{shape, std::move(material), std::move(interior)}};
    scene.lights = {std::make_shared<ConstantEnvironment>(Color(0.5, 0.8, 1))};
    scene.camera = std::make_shared<PinholeCamera>(Vec3(0.5, 1, 5), Vec3(0.1, 0.2, 0), Vec3::UnitY(), 0.5, 64, 64);
    return scene;
}

std::shared_ptr<const Shape> ball() { return std::make_shared<Sphere>(Vec3(0.1, 0.2, 0), 1); }

std::shared_ptr<const Shape> mapped(Lookup lookup, std::shared_ptr<const Shape> shape = ball(), Real slope = 1.2) {
    return std::make_shared<NormalMappedShape>(std::move(shape),
                                               std::make_shared<NormalMap>(roughNormals(3, slope), lookup, Vec2(3, 2)));
}

Rendering rendered(const SceneDescription& description, std::int64_t passes) {
    const Scene scene(description);
    PathTracer tracer(scene, sampler, filter, {});
    return render(tracer, {.passes = passes, .threads = 2});
}

int blackPixels(const Image& picture) {
    int black = 0;
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) black += picture.at(x, y).maxCoeff() == 0 ? 1 : 0;
    }
    return black;
}

TEST(NormalMap, DecodesCodesAsTheyAreMeant) {
    Image codes(3, 1);
    codes.set(0, 0, Color(128, 128, 255) / 255);
    codes.set(1, 0, Color(1, 255, 200) / 255);
    codes.set(2, 0, Color(255, 1, 129) / 255);
    const Image normals = decodedNormals(codes, PngDepth::Bits8);
    EXPECT_TRUE((normals.at(0, 0) == Color(0, 0, 1)).all()) << "flat is flat";
    EXPECT_LT((normals.at(1, 0) - Color(-1, 1, 72.0 / 127)).abs().maxCoeff(), 1e-6);
    const NormalMap map(normals);
    EXPECT_EQ(map.at({0.5 / 3, 0.3}), Vec3(0, 0, 1));
    Image fine(1, 1, Color(32768, 32768, 65535) / 65535);
    EXPECT_TRUE((decodedNormals(fine, PngDepth::Bits16).at(0, 0) == Color(0, 0, 1)).all());
}

// Of a wave along u and a slope, by its derivative; v goes up and rows go down.
TEST(NormalMap, NormalsOfHeights) {
    constexpr int side = 64;
    Image heights(side, side);
    const auto wave = [](Real x) { return 3 * std::sin(2 * 3.14159265358979 * x / side); };
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) heights.set(x, y, Color::Constant(wave(x) + 2 * wave(y)));
    }
    const Image normals = normalsOfHeights(heights);
    for (int i = 0; i < side; ++i) {
        const Real slope = 2 * 3.14159265358979 / side * 3 * std::cos(2 * 3.14159265358979 * i / side);
        const Color normal = normals.at(i, (i * 7) % side);
        EXPECT_NEAR(-normal.x() / normal.z(), slope, 1e-3);
        const Color other = normals.at((i * 5) % side, i);
        EXPECT_NEAR(-other.y() / other.z(), -2 * slope, 2e-3);
    }
}

TEST(NormalMap, RefusesNormalsThatPointInwards) {
    for (const Color& bad : {Color(0, 0, 0), Color(0.1, 0.2, -0.5), Color(std::nan(""), 0, 1)}) {
        Image normals(3, 2, Color(0, 0, 1));
        normals.set(2, 1, bad);
        EXPECT_THROW(NormalMap{normals}, InputError);
    }
    EXPECT_THROW(NormalMap(Image(2, 2, Color(0, 0, 1)), Lookup::Nearest, {0, 1}), InputError);
    EXPECT_THROW(NormalMappedShape(nullptr, std::make_shared<NormalMap>(Image(1, 1, Color(0, 0, 1)))), InputError);
    EXPECT_THROW(NormalMappedShape(ball(), nullptr), InputError);
}

// Bit for bit the picture without a map: by photons, too.
TEST(NormalMappedShape, FlatMapChangesNothing) {
    const std::shared_ptr<const Material> materials[] = {
        std::make_shared<DiffuseMaterial>(Color(0.3, 0.6, 0.5)), std::make_shared<DielectricMaterial>(),
        std::make_shared<RoughConductorMaterial>(Metal::gold(), 0.2, 0.4)};
    for (const auto& material : materials) {
        const std::optional<Interior> interior = anyOf(material->lobes(), LobeFlags::Transmission)
                                                     ? std::optional<Interior>({1.5, nullptr, 0})
                                                     : std::nullopt;
        const Image plain = rendered(ballScene(ball(), material, interior), 2).film.image();
        for (const Lookup lookup : {Lookup::Nearest, Lookup::Bilinear}) {
            const auto flat = std::make_shared<NormalMappedShape>(
                ball(), std::make_shared<NormalMap>(
                            decodedNormals(Image(4, 4, Color(128, 128, 255) / 255), PngDepth::Bits8), lookup));
            const Image shown = rendered(ballScene(flat, material, interior), 2).film.image();
            EXPECT_TRUE(test::sameBits(plain, shown));
        }
    }
}

// Where the smooth ball has none, the dented one has no black pixel: nearest and bilinear, mirror, rough metal, paint,
// glass. On glass as steep as that, what should leave it is refracted back into it in places, and lost.
TEST(NormalMappedShape, NoPixelGoesBlack) {
    const std::shared_ptr<const Material> materials[] = {
        std::make_shared<MirrorMaterial>(Color(0.9, 0.8, 0.7)),
        std::make_shared<RoughConductorMaterial>(Metal::gold(), 0.1, 0.1),
        std::make_shared<DiffuseMaterial>(Color(0.3, 0.6, 0.5)), std::make_shared<DielectricMaterial>()};
    for (const auto& material : materials) {
        const std::optional<Interior> interior = anyOf(material->lobes(), LobeFlags::Transmission)
                                                     ? std::optional<Interior>({1.5, nullptr, 0})
                                                     : std::nullopt;
        ASSERT_EQ(blackPixels(rendered(ballScene(ball(), material, interior), 16).film.image()), 0);
        for (const Lookup lookup : {Lookup::Nearest, Lookup::Bilinear}) {
            const Real slope = interior ? 0.3 : 1.2;
            const Rendering shown = rendered(ballScene(mapped(lookup, ball(), slope), material, interior), 16);
            EXPECT_EQ(blackPixels(shown.film.image()), 0);
            EXPECT_EQ(shown.film.badSamples(), 0);
        }
    }
}

// A mirrored instance has mirrored dents: seen in the mirror's plane, the same normals.
TEST(NormalMappedShape, MirroredInstancesHaveMirroredDents) {
    const auto original = mapped(Lookup::Bilinear, std::make_shared<Sphere>(Vec3(0.3, 0, 0), 0.7));
    const Transform mirror = Transform::scaling({-1, 1, 1});
    const auto inside = std::make_shared<Instance>(original, mirror);
    const auto outside = std::make_shared<NormalMappedShape>(
        std::make_shared<Instance>(std::make_shared<Sphere>(Vec3(0.3, 0, 0), 0.7), mirror),
        std::make_shared<NormalMap>(roughNormals(3), Lookup::Bilinear, Vec2(3, 2)));
    Random random(7, {1});
    int hits = 0;
    for (int i = 0; i < 1000; ++i) {
        const Ray ray = {Vec3(random.uniform(-1, 1), random.uniform(-1, 1), 3),
                         Vec3(random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1), -1).normalized()};
        const auto there = original->intersect(mirror.ray(ray));
        if (!there) continue;
        ++hits;
        const Vec3 expected(-there->ns.x(), there->ns.y(), there->ns.z());
        ASSERT_LT((inside->intersect(ray)->ns - expected).norm(), 1e-9);
        ASSERT_LT((outside->intersect(ray)->ns - expected).norm(), 1e-9);
    }
    EXPECT_GT(hits, 300);
}

}  // namespace
}  // namespace caustic
