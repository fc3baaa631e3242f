// Materials see the whole hit: what has a direction on a surface follows its parameters, mirrored ones too.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <memory>

#include "core/random.h"
#include "material/rough_conductor_material.h"
#include "mesh/triangle_mesh.h"
#include "scene/scene.h"
#include "shape/instance.h"

namespace caustic {
namespace {

const auto brushed = std::make_shared<RoughConductorMaterial>(Metal::gold(), 0.4, 0.05);
const auto brushedAcross = std::make_shared<RoughConductorMaterial>(Metal::gold(), 0.05, 0.4);

// A parallelogram of two triangles that slants in space, with normals that slant elsewhere; its uvs are those of a unit
// square after a map.
std::shared_ptr<const Shape> slanted(const std::function<Vec2(Vec2)>& uv) {
    MeshData mesh;
    const Vec3 origin(0.3, -0.2, 0.1);
    const Vec3 alongU(1.1, 0.2, 0.3);
    const Vec3 alongV(-0.25, 0.9, 0.2);
    for (const Vec2& corner : {Vec2(0, 0), Vec2(1, 0), Vec2(1, 1), Vec2(0, 1)}) {
        mesh.positions.push_back(origin + corner.x() * alongU + corner.y() * alongV);
        mesh.uvs.push_back(uv(corner));
        mesh.normals.push_back((alongU.cross(alongV) + 0.1 * corner.x() * alongU - 0.2 * alongV).normalized());
    }
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    mesh.uvCorners = mesh.triangles;
    mesh.normalCorners = mesh.triangles;
    return std::make_shared<TriangleMesh>(mesh);
}

Ray random(Random& random) {
    const Vec3 from(random.uniform() * 4 - 2, random.uniform() * 4 - 2, 3 + random.uniform());
    const Vec3 to(0.3 + 0.8 * random.uniform(), 0.6 * random.uniform(), 0.3);
    return {from, (to - from).normalized()};
}

// What is scattered along a direction where the ray meets the shape.
Color scattered(const std::shared_ptr<const Shape>& shape, const std::shared_ptr<const Material>& material,
                const Ray& ray, const Vec3& wi, Real& handedness) {
    SceneDescription description;
    description.objects = {{shape, material, {}, nullptr}};
    const Scene scene(description);
    MediumStack media;
    Color passed;
    RayCounts counts;
    const auto at = scene.follow(ray, media, passed, counts);
    if (!at) return Color::Constant(-1);
    handedness = at->hit().handedness();
    return at->bsdf()->f(-ray.direction, wi, TransportMode::Radiance);
}

void expectSame(const Color& one, const Color& other) {
    EXPECT_LE((one - other).abs().maxCoeff(), 1e-9 * (1 + one.maxCoeff()));
}

TEST(HitFrame, BrushedMetalFollowsMirroredAndTurnedParameters) {
    const auto plain = slanted([](Vec2 uv) { return uv; });
    const auto mirrored = slanted([](Vec2 uv) { return Vec2(1 - uv.x(), uv.y()); });
    const auto exchanged = slanted([](Vec2 uv) { return Vec2(uv.y(), uv.x()); });
    const auto turned = slanted([](Vec2 uv) { return Vec2(-uv.x(), -uv.y()); });
    Random numbers(7, {});
    int met = 0;
    Real largest = 0;
    for (int i = 0; i < 400; ++i) {
        const Ray ray = random(numbers);
        const Vec3 wi = Vec3(numbers.uniform() - 0.5, numbers.uniform() - 0.5, 0.5 + numbers.uniform()).normalized();
        Real hand = 0;
        const Color expected = scattered(plain, brushed, ray, wi, hand);
        if (expected.x() < 0) continue;
        ++met;
        EXPECT_EQ(hand, 1);
        expectSame(scattered(mirrored, brushed, ray, wi, hand), expected);
        EXPECT_EQ(hand, -1);
        expectSame(scattered(turned, brushed, ray, wi, hand), expected);
        EXPECT_EQ(hand, 1);
        const Color across = scattered(exchanged, brushed, ray, wi, hand);
        EXPECT_EQ(hand, -1);
        largest = std::max(largest, (across - expected).abs().maxCoeff());
    }
    EXPECT_GT(met, 100);
    EXPECT_GT(largest, 0.1) << "brushed along v looks otherwise than along u";
}

// On a square whose sides are perpendicular, exchanging u and v is exchanging the roughnesses.
TEST(HitFrame, ExchangedParametersExchangeTheRoughnesses) {
    for (const bool mirrored : {false, true}) {
        ShadingFrame frames[2];
        Hit hit;
        hit.ns = hit.ng = Vec3(0.6, 0, 0.8);
        hit.dpdu = Vec3(0, 3, 0);
        hit.dpdv = (mirrored ? -2 : 2) * hit.ng.cross(Vec3(0, 1, 0));
        EXPECT_EQ(hit.handedness(), mirrored ? -1 : 1);
        frames[0] = ShadingFrame::at(hit, 1, 1);
        std::swap(hit.dpdu, hit.dpdv);
        EXPECT_EQ(hit.handedness(), mirrored ? 1 : -1);
        frames[1] = ShadingFrame::at(hit, 1, 1);
        BsdfBuffer along;
        BsdfBuffer across;
        brushed->build(hit, frames[0], along);
        brushedAcross->build(hit, frames[1], across);
        const Vec3 wo = Vec3(0.5, 0.4, 0.7).normalized();
        const Vec3 wi = Vec3(0.4, -0.1, 0.9).normalized();
        const Color f = along.get()->f(wo, wi, TransportMode::Radiance);
        EXPECT_GT(f.x(), 1e-3);
        expectSame(across.get()->f(wo, wi, TransportMode::Radiance), f);
    }
}

// A mirrored instance is the picture in a mirror: rays that are mirrored too see the same.
TEST(HitFrame, MirroredInstancesScatterAsInAMirror) {
    const auto plain = slanted([](Vec2 uv) { return Vec2(uv.x() + 0.7 * uv.y(), uv.y()); });
    const auto mirrored = std::make_shared<Instance>(plain, Transform::scaling({-1, 1, 1}), noObject);
    const auto flipped = [](const Vec3& v) { return Vec3(-v.x(), v.y(), v.z()); };
    Random numbers(8, {});
    int met = 0;
    for (int i = 0; i < 400; ++i) {
        const Ray ray = random(numbers);
        const Vec3 wi = Vec3(numbers.uniform() - 0.5, numbers.uniform() - 0.5, 0.5 + numbers.uniform()).normalized();
        Real hand = 0;
        const Color expected = scattered(plain, brushed, ray, wi, hand);
        if (expected.x() < 0) continue;
        ++met;
        EXPECT_EQ(hand, 1);
        expectSame(scattered(mirrored, brushed, {flipped(ray.origin), flipped(ray.direction)}, flipped(wi), hand),
                   expected);
        EXPECT_EQ(hand, -1);
    }
    EXPECT_GT(met, 100);
}

}  // namespace
}  // namespace caustic
