#include <gtest/gtest.h>

#include <memory>
#include <set>

#include "integrator/path_hash.h"
#include "material/dielectric_material.h"
#include "material/diffuse_material.h"
#include "material/mirror_material.h"
#include "material/refraction_material.h"
#include "modeler/objects.h"
#include "shape/plane.h"
#include "shape/sphere.h"
#include "support/leaning_mesh.h"

namespace caustic {
namespace {

// Two floors side by side, a diffuse wall behind; a glass ball and a mirror ball, both in front of the wall; a lamp.
struct Room {
    Scene scene = Scene(description());
    RayCounts counts;

    static SceneDescription description() {
        SceneDescription room;
        room.objects = {diffuseRectangle({-4, 0, -4}, {0, 0, 8}, {4, 0, 0}, Color(0.7, 0.2, 0.1)),
                        diffuseRectangle({0, 0, -4}, {0, 0, 8}, {4, 0, 0}, Color(0.1, 0.2, 0.7)),
                        diffuseRectangle({-4, 0, -4}, {8, 0, 0}, {0, 5, 0}, Color(0.4, 0.5, 0.4)),
                        glassBall({-1.5, 1.2, 0}, 0.9, 1.5),
                        mirrorBall({1.5, 1.2, 0}, 0.9),
                        rectangleLamp({-1, 5, -1}, {2, 0, 0}, {0, 0, 2}, Color::Ones())};
        return room;
    }
    std::uint64_t hash(const Vec3& from, const Vec3& to, int segments = 10) {
        return pathHash(scene, {from, (to - from).normalized()}, segments, counts);
    }
};

const Vec3 eye(0.2, 2.2, 6);

// Varnished: a mirror over a diffuse ground.
class VarnishBsdf final : public Bsdf {
public:
    explicit VarnishBsdf(const ShadingFrame& shading) : Bsdf(shading) {}
    LobeFlags lobes() const override { return LobeFlags::Diffuse | LobeFlags::Delta | LobeFlags::Reflection; }

private:
    Color localF(const Vec3&, const Vec3&, Real) const override { return Color(0.2, 0.1, 0.05); }
    Real localPdfW(const Vec3&, const Vec3& wi, Real) const override { return wi.z() / 4; }
    std::optional<BsdfSample> localSample(const Vec3&, const Vec2&, Real, Real) const override { return std::nullopt; }
    DeltaLobes localDeltaLobes(const Vec3& wo, Real) const override {
        DeltaLobes all;
        all.add({{-wo.x(), -wo.y(), wo.z()}, Color::Constant(0.1), 0.2, 1, LobeFlags::Delta | LobeFlags::Reflection});
        return all;
    }
};

class VarnishMaterial final : public Material {
public:
    void build(const Hit&, const ShadingFrame& shading, BsdfBuffer& bsdf) const override {
        bsdf.emplace<VarnishBsdf>(shading);
    }
    LobeFlags lobes() const override { return LobeFlags::Diffuse | LobeFlags::Delta | LobeFlags::Reflection; }
};

// What light takes the same way to has the same number: rays side by side, and the same ray again.
TEST(PathHash, IsTheSameForTheSameWay) {
    Room room;
    for (const Vec3& to : {Vec3(-2, 0, 2), Vec3(2, 0, 2.5), Vec3(0.1, 3, -4), Vec3(-1.5, 1.25, 0), Vec3(1.5, 1.6, 0)}) {
        std::set<std::uint64_t> hashes;
        for (int i = 0; i < 50; ++i) hashes.insert(room.hash(eye, to + 1e-4 * Vec3(i % 7, 0, i % 5)));
        EXPECT_EQ(hashes.size(), 1U) << "to " << to.transpose() << ": No number of the path is random.";
    }
    // Smooth normals lean; the side is the flat surface's.
    SceneDescription smooth;
    smooth.objects = {{test::leaningPlane({1, 2, 3}, Vec3::UnitZ(), Vec3(0.9, 0, 0.4), 50),
                       std::make_shared<DiffuseMaterial>(Color(0.5, 0.2, 0.1))}};
    const Scene leaning(smooth);
    EXPECT_EQ(pathHash(leaning, {Vec3(1, 2, 5), Vec3(3, 0, -1).normalized()}, 9, room.counts),
              pathHash(leaning, {Vec3(1, 2, 5), Vec3(-3, 0, -1).normalized()}, 9, room.counts))
        << "Both rays come from the front: which normal says so?";
    // A ball of glass within a ball of the same glass: where the larger one is, the smaller one isn't.
    SceneDescription glass;
    glass.objects = {glassBall({0, 0, 0}, 2, 1.5)};
    const Scene one(glass);
    glass.objects.push_back(glassBall({0.1, 0.2, 0}, 1, 1.5));
    const Scene nested(glass);
    const Ray through = {Vec3(0.3, 0.4, 5), -Vec3::UnitZ()};
    EXPECT_EQ(pathHash(nested, through, 9, room.counts), pathHash(one, through, 9, room.counts))
        << "What is the path in, when it has gone through a surface?";
}

// Another object, over the mirror or through the glass or straight: each another number.
TEST(PathHash, TellsObjectsApart) {
    Room room;
    std::set<std::uint64_t> hashes;
    hashes.insert(room.hash(eye, {-2, 0, 2}));       // left floor
    hashes.insert(room.hash(eye, {2, 0, 2.5}));      // right floor
    hashes.insert(room.hash(eye, {0.1, 3, -4}));     // wall
    hashes.insert(room.hash(eye, {-1.5, 1.25, 0}));  // through the glass
    hashes.insert(room.hash(eye, {1.7, 1.55, 0}));   // over the mirror
    hashes.insert(room.hash(eye, {0, 4.5, 20}));     // out of the room
    hashes.insert(room.hash(eye, {0.1, 5, 0.2}));    // the lamp, which scatters nothing
    EXPECT_EQ(hashes.size(), 7U) << "Do the objects of the whole path go in, and a way out of the scene, too?";

    // Walls one behind the other, each seen from either side, and nothing: all different.
    SceneDescription walls;
    for (int i = 0; i < 9; ++i)
        walls.objects.push_back(diffuseRectangle({-1, -1, Real(i)}, {2, 0, 0}, {0, 2, 0}, Color::Ones()));
    const Scene row(walls);
    RayCounts counts;
    hashes = {pathHash(row, {Vec3(0, 0, -1), -Vec3::UnitZ()}, 5, counts)};
    for (int i = 0; i < 9; ++i) {
        hashes.insert(pathHash(row, {Vec3(0.1, 0.2, i - 0.5), Vec3::UnitZ()}, 5, counts));
        hashes.insert(pathHash(row, {Vec3(0.1, 0.2, i + 0.5), -Vec3::UnitZ()}, 5, counts));
    }
    EXPECT_EQ(hashes.size(), 19U) << "Has each object, from each side, a number that nothing else has?";
}

// What the mirror shows counts, and what is behind the glass.
TEST(PathHash, GoesOnOverMirrorsAndThroughGlass) {
    Room room;
    EXPECT_NE(room.hash({1.5, 2.6, 3}, {1.5, 0.6, 0.5}), room.hash({1.5, 2.6, 3}, {1.5, 1.7, 0.5}))
        << "In the mirror: floor, or what is behind the eye?";
    EXPECT_NE(room.hash(eye, {-1.5, 1.25, 0}, 3), room.hash(eye, {-1.5, 1.25, 0}, 1))
        << "Two more segments go through the glass to what is behind it.";
    EXPECT_EQ(room.hash(eye, {-1.5, 1.25, 0}, 3), room.hash(eye, {-1.5, 1.25, 0}, 50))
        << "It ends where light is spread.";

    // It ends where light is spread, even if some of it is mirrored; and where light goes nowhere: in black glass.
    SceneDescription ends;
    ends.objects = {diffuseRectangle({-2, -2, 0}, {4, 0, 0}, {0, 4, 0}, Color::Ones()),
                    diffuseRectangle({-9, -9, 9}, {18, 0, 0}, {0, 18, 0}, Color::Ones())};
    for (const std::shared_ptr<const Material>& last : std::initializer_list<std::shared_ptr<const Material>>{
             std::make_shared<VarnishMaterial>(), std::make_shared<RefractionMaterial>(Color::Zero(), Color::Zero())}) {
        ends.objects[0].material = last;
        const Scene scene(ends);
        RayCounts own;
        pathHash(scene, {Vec3(0.5, 0.3, 2), Vec3(0.1, 0.2, -1).normalized()}, 9, own);
        EXPECT_EQ(own.rays, 1) << "Does the path end where light is spread, and where there is no way on?";
    }

    // Behind a pane that light goes through one way: a floor in one piece, and a wall of two pieces that it mirrors.
    SceneDescription description;
    description.objects = {{std::make_shared<Plane>(Vec3::Zero(), Vec3::UnitZ()),
                            std::make_shared<DielectricMaterial>(), Interior{1.5, nullptr, 0}, nullptr},
                           diffuseRectangle({-99, -99, -1}, {198, 0, 0}, {0, 198, 0}, Color::Ones()),
                           diffuseRectangle({90, -99, -0.5}, {0, 99, 0}, {0, 0, 90}, Color::Ones()),
                           diffuseRectangle({90, 0, -0.5}, {0, 99, 0}, {0, 0, 90}, Color::Ones())};
    const Scene pane(description);
    RayCounts counts;
    const auto hashOf = [&](Real slope, Real aside) {
        return pathHash(pane, {Vec3(0, aside, 1), Vec3(1, aside, -slope).normalized()}, 9, counts);
    };
    EXPECT_NE(hashOf(0.05, 0.01), hashOf(0.05, -0.01)) << "Flat on it most light is mirrored: where does the path go?";
    EXPECT_EQ(hashOf(2, 0.01), hashOf(2, -0.01)) << "From above most light goes through: where does the path go?";
    EXPECT_NE(hashOf(2, 0.01), hashOf(0.05, 0.01));

    // The same pane within a large ball: mirrored or let through, light meets the ball from inside.
    description.objects.resize(1);
    description.objects.push_back(
        {std::make_shared<Sphere>(Vec3(3, 1, 2), 50), std::make_shared<DiffuseMaterial>(Color(0.5, 0.2, 0.1))});
    const Scene within(description);
    const auto hashWithin = [&](Real slope) {
        return pathHash(within, {Vec3(0, 0, 1), Vec3(1, 0, -slope).normalized()}, 9, counts);
    };
    EXPECT_NE(hashWithin(2), hashWithin(0.05)) << "The same objects in the same order: did light go through, or not?";
}

// The side from which an object is met, and the order in which objects are.
TEST(PathHash, TellsSidesAndOrderApart) {
    SceneDescription description;
    description.objects = {diffuseRectangle({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, Color(0.5, 0.2, 0.1))};
    description.objects[0].material = std::make_shared<MirrorMaterial>(Color::Ones());
    const Scene alone(description);
    RayCounts counts;
    EXPECT_NE(pathHash(alone, {Vec3(0.1, 0.2, 3), -Vec3::UnitZ()}, 9, counts),
              pathHash(alone, {Vec3(0.1, 0.2, -3), Vec3::UnitZ()}, 9, counts))
        << "From behind it is another sight.";
    const Vec3 aslant = Vec3(0.4, 0.3, 1).normalized();
    EXPECT_NE(pathHash(alone, {Vec3(0.1, 0.2, 0) + 3 * aslant, -aslant}, 9, counts),
              pathHash(alone, {Vec3(0.1, 0.2, 0) - 3 * aslant, aslant}, 9, counts))
        << "From behind it is another sight, aslant as well.";
    // Between two mirrors that face each other: first one or first the other, as many times each.
    description.objects = {mirrorBall({-2, 0, 0}, 1), mirrorBall({2, 0, 0}, 1)};
    const Scene between(description);
    EXPECT_NE(pathHash(between, {Vec3(0, 0, 0), Vec3::UnitX()}, 2, counts),
              pathHash(between, {Vec3(0, 0, 0), -Vec3::UnitX()}, 2, counts))
        << "Is a sum, or an exclusive or, told apart from another order?";
    // To and fro between them for as many segments as are allowed, and each makes it another way.
    std::set<std::uint64_t> hashes;
    for (int segments = 1; segments <= 6; ++segments) {
        RayCounts own;
        hashes.insert(pathHash(between, {Vec3(0, 0, 0), Vec3::UnitX()}, segments, own));
        EXPECT_EQ(own.rays, segments) << "How many segments may a path have?";
    }
    EXPECT_EQ(hashes.size(), 6U) << "Does each segment count?";
}

}  // namespace
}  // namespace caustic
