#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "mesh/mesh_file.h"
#include "mesh/mesh_tree.h"
#include "mesh/triangle_mesh.h"
#include "mesh_sets.h"
#include "shape/group.h"
#include "shape/instance.h"
#include "shape/plane.h"
#include "shape/shape_tree.h"
#include "shape/sphere.h"
#include "support/in_cube.h"
#include "support/paths.h"

namespace caustic {
namespace {

using test::inCube;

// Whether two answers name the same triangle; exact ties aside.
bool agree(const std::optional<MeshHit>& found, const std::optional<MeshHit>& truth) {
    if (found.has_value() != truth.has_value()) return false;
    return !found || found->triangle == truth->triangle || found->t == truth->t;
}

// Brute force needs no tree: it is the definition of the nearest hit.
TEST(MeshTrees, AgreeWithBruteForceOnEverySet) {
    for (const MeshSet& set : meshSets()) {
        Random maker(5, {0});
        const auto mesh = std::make_shared<const MeshData>(set.make(maker, 200));
        const Bounds3 box = boundsOf(*mesh);
        const auto brute = plantMeshTree(MeshTreeKind::BruteForce, mesh);
        for (const MeshTreeKind kind : allMeshTrees) {
            const auto tree = plantMeshTree(kind, mesh);
            int hits = 0;
            for (std::uint64_t i = 0; i < 10'000; ++i) {
                Random random(6, {i});
                const Ray ray = randomRayAt(*mesh, box, random);
                const auto truth = brute->intersect(ray);
                hits += truth ? 1 : 0;
                const auto found = tree->intersect(ray);
                ASSERT_TRUE(agree(found, truth)) << set.name << ", " << name(kind) << ", ray " << i;
                if (found) {
                    ASSERT_EQ(found->t, truth->t) << "t comes from the same test, whatever the tree";
                }
                ASSERT_EQ(tree->occluded(ray), truth.has_value()) << set.name << ", " << name(kind) << ", ray " << i;
                MeshWork work;
                ASSERT_EQ(tree->intersectCounted(ray, work).has_value(), truth.has_value());
            }
            EXPECT_GT(hits, 1000) << set.name << ": the rays must hit something to be of use";
        }
    }
}

// A piece of a ray sees what lies within it, wherever it is cut.
TEST(MeshTrees, KeepToTheRaysEnds) {
    Random maker(5, {0});
    const auto mesh = std::make_shared<const MeshData>(meshSets()[0].make(maker, 200));
    const Bounds3 box = boundsOf(*mesh);
    const auto brute = plantMeshTree(MeshTreeKind::BruteForce, mesh);
    for (const MeshTreeKind kind : allMeshTrees) {
        const auto tree = plantMeshTree(kind, mesh);
        for (std::uint64_t i = 0; i < 10'000; ++i) {
            Random random(8, {i});
            Ray ray = randomRayAt(*mesh, box, random);
            ray.direction *= std::pow(10, random.uniform(-6, 6));
            const Real whole = 4 / ray.direction.norm();
            ray.tMin = whole * random.uniform(-0.5, 1);
            ray.tMax = ray.tMin + whole * random.uniform(0, 1);
            const auto truth = brute->intersect(ray);
            ASSERT_TRUE(agree(tree->intersect(ray), truth)) << name(kind) << ", ray " << i;
            ASSERT_EQ(tree->occluded(ray), truth.has_value()) << name(kind) << ", ray " << i;
        }
    }
}

// Scaling a mesh by a power of two changes no digit; moving it far away costs digits of the mesh, not of the answer.
TEST(MeshTrees, AgreeAtEveryScaleAndFarFromTheOrigin) {
    for (const Real scale : {0x1p-100, 1e-6, 1.0, 1e6, 0x1p100}) {
        for (const Real away : {0.0, 10.0, 1e5}) {
            Random maker(5, {0});
            MeshData moved = meshSets()[0].make(maker, 100);
            for (Vec3& position : moved.positions) position = scale * (position + away * Vec3(0.3, -0.7, 0.6));
            const auto mesh = std::make_shared<const MeshData>(std::move(moved));
            const Bounds3 box = boundsOf(*mesh);
            const auto brute = plantMeshTree(MeshTreeKind::BruteForce, mesh);
            for (const MeshTreeKind kind : allMeshTrees) {
                const auto tree = plantMeshTree(kind, mesh);
                for (std::uint64_t i = 0; i < 1000; ++i) {
                    Random random(9, {i});
                    Ray ray = randomRayAt(*mesh, box, random);
                    if (i % 2 == 0) ray.direction.normalize();
                    ASSERT_TRUE(agree(tree->intersect(ray), brute->intersect(ray)))
                        << name(kind) << ", scale " << scale << ", away " << away << ", ray " << i;
                }
            }
        }
    }
}

// The mesh with its coordinates cut off to floats, each times a power of two.
MeshData inFloats(MeshData mesh, Real scale) {
    constexpr std::uint64_t whatFloatsHold = ~std::uint64_t{0x1fffffff};
    for (Vec3& position : mesh.positions) {
        for (Real& x : position) x = scale * std::bit_cast<Real>(std::bit_cast<std::uint64_t>(x) & whatFloatsHold);
    }
    return mesh;
}

// Trees keep floats where all coordinates are floats, which halves their blocks; one digit more anywhere, or a float
// out of its range, and they keep Reals. Either way the answer is that of brute force, to the last bit.
TEST(MeshTrees, KeepFloatsOnlyWhereNothingIsLost) {
    struct Case {
        Real scale;
        bool floats;
    };
    for (const auto& [scale, floats] :
         {Case{1, true}, {0x1p-100, true}, {0x1p100, true}, {0x1p-140, false}, {0x1p140, false}}) {
        for (const bool oneDigitMore : {false, true}) {
            Random maker(5, {0});
            MeshData rounded = inFloats(meshSets()[0].make(maker, 400), scale);
            Real& last = rounded.positions.back().y();
            if (oneDigitMore) last = std::nextafter(last, Real{1});
            const auto mesh = std::make_shared<const MeshData>(std::move(rounded));
            const Bounds3 box = boundsOf(*mesh);
            const auto brute = plantMeshTree(MeshTreeKind::BruteForce, mesh);
            for (const MeshTreeKind kind : {MeshTreeKind::WideKdTree, MeshTreeKind::WideBvh}) {
                const auto tree = plantMeshTree(kind, mesh);
                const MeshTreeSize size = tree->size();
                const Real bytes = static_cast<Real>(size.bytes) / static_cast<Real>(size.references);
                EXPECT_EQ(bytes < 75, floats && !oneDigitMore)
                    << name(kind) << ", scale " << scale << ": " << bytes << " bytes a reference";
                for (std::uint64_t i = 0; i < 2000; ++i) {
                    Random random(13, {i});
                    const Ray ray = randomRayAt(*mesh, box, random);
                    const auto truth = brute->intersect(ray);
                    const auto found = tree->intersect(ray);
                    ASSERT_TRUE(agree(found, truth)) << name(kind) << ", scale " << scale << ", ray " << i;
                    if (found) {
                        ASSERT_EQ(found->t, truth->t) << name(kind) << ", scale " << scale << ", ray " << i;
                    }
                }
            }
        }
    }
}

// A direction may have any length: t counts in it, and nothing else changes.
TEST(MeshTrees, AgreeForDirectionsOfAnyLength) {
    Random maker(5, {1});
    const auto mesh = std::make_shared<const MeshData>(meshSets()[0].make(maker, 150));
    const Bounds3 box = boundsOf(*mesh);
    const auto brute = plantMeshTree(MeshTreeKind::BruteForce, mesh);
    for (const MeshTreeKind kind : allMeshTrees) {
        const auto tree = plantMeshTree(kind, mesh);
        int hits = 0;
        for (std::uint64_t i = 0; i < 2000; ++i) {
            Random random(19, {i});
            Ray ray = randomRayAt(*mesh, box, random);
            ray.direction *= std::array<Real, 6>{1e-250, 1e-100, 1e-20, 1e20, 1e100, 1e250}[i % 6];
            if (i % 5 == 0) ray.direction[static_cast<int>(i % 3)] = 0;
            const auto truth = brute->intersect(ray);
            hits += truth ? 1 : 0;
            ASSERT_TRUE(agree(tree->intersect(ray), truth)) << name(kind) << ", ray " << i;
            ASSERT_EQ(tree->occluded(ray), truth.has_value()) << name(kind) << ", ray " << i;
        }
        EXPECT_GT(hits, 500) << name(kind);
    }
}

// Each triangle half as large as the one before, all towards one corner: no plane halves what is left.
TEST(MeshTrees, AgreeWhereTrianglesShrinkTowardsACorner) {
    MeshData shrinking;
    Random maker(17, {0});
    for (std::uint32_t i = 0; i < 500; ++i) {
        for (int corner = 0; corner < 3; ++corner) {
            shrinking.positions.push_back(std::exp2(-0.5 * i) * (Vec3(1, 1, 1) + 0.9 * inCube(maker)));
        }
        shrinking.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
    const auto mesh = std::make_shared<const MeshData>(std::move(shrinking));
    const auto brute = plantMeshTree(MeshTreeKind::BruteForce, mesh);
    for (const MeshTreeKind kind : allMeshTrees) {
        const auto tree = plantMeshTree(kind, mesh);
        int hits = 0;
        for (std::uint64_t i = 0; i < 3000; ++i) {
            Random random(18, {i});
            const auto [a, b, c] = mesh->corners(static_cast<std::uint32_t>(i) % 500);
            const Vec3 aim = 0.5 * a + 0.3 * b + 0.2 * c;
            const Vec3 origin = aim + (b - a).norm() * inCube(random);
            const Ray ray = {origin, aim - origin};
            const auto truth = brute->intersect(ray);
            hits += truth ? 1 : 0;
            ASSERT_TRUE(agree(tree->intersect(ray), truth)) << name(kind) << ", ray " << i;
            ASSERT_EQ(tree->occluded(ray), truth.has_value()) << name(kind) << ", ray " << i;
        }
        EXPECT_GT(hits, 2900) << name(kind);
    }
}

// From a million sizes away, and farther than where floats can tell where a ray enters.
TEST(MeshTrees, AgreeForRaysFromVeryFar) {
    const auto mesh = std::make_shared<const MeshData>(bumpySphere(500));
    const auto brute = plantMeshTree(MeshTreeKind::BruteForce, mesh);
    for (const MeshTreeKind kind : allMeshTrees) {
        const auto tree = plantMeshTree(kind, mesh);
        for (const Real distance : {1e3, 1e6, 1e9, 1e12}) {
            int hits = 0;
            for (std::uint64_t i = 0; i < 500; ++i) {
                Random random(10, {i});
                const Vec3 origin = distance * inCube(random);
                const Ray ray = {origin, (0.9 * inCube(random) - origin).normalized()};
                const auto truth = brute->intersect(ray);
                hits += truth ? 1 : 0;
                ASSERT_TRUE(agree(tree->intersect(ray), truth)) << name(kind) << " from " << distance;
            }
            EXPECT_GT(hits, 100);
        }
    }
}

// On a mesh that somebody scanned; brute force is slow, so few rays.
TEST(MeshTrees, AgreeWithBruteForceOnTheBunny) {
    const auto mesh = std::make_shared<const MeshData>(loadMesh(test::sourceDir() / "assets/meshes/bunny.ply"));
    const Bounds3 box = boundsOf(*mesh);
    const auto brute = plantMeshTree(MeshTreeKind::BruteForce, mesh);
    std::vector<std::unique_ptr<const MeshTree>> trees;
    for (const MeshTreeKind kind : allMeshTrees) {
        if (kind != MeshTreeKind::BruteForce) trees.push_back(plantMeshTree(kind, mesh));
    }
    for (std::uint64_t i = 0; i < 1000; ++i) {
        Random random(11, {i});
        const Ray ray = i % 2 == 0 ? randomRayAt(*mesh, box, random) : randomChord(box, random);
        const auto truth = brute->intersect(ray);
        for (const auto& tree : trees) ASSERT_TRUE(agree(tree->intersect(ray), truth)) << "ray " << i;
    }
    // And each other, on many more.
    for (std::uint64_t i = 0; i < 100'000; ++i) {
        Random random(12, {i});
        const Ray ray = i % 2 == 0 ? randomRayAt(*mesh, box, random) : randomChord(box, random);
        const auto first = trees[0]->intersect(ray);
        for (const auto& tree : trees) ASSERT_TRUE(agree(tree->intersect(ray), first)) << "ray " << i;
    }
}

// 8 + 1.3 log2 n, whatever the triangles are like.
TEST(MeshTrees, DepthIsBounded) {
    for (const MeshSet& set : meshSets()) {
        for (const std::uint32_t triangles : {2U, 10U, 100U, 3000U}) {
            Random maker(5, {0});
            const auto mesh = std::make_shared<const MeshData>(set.make(maker, triangles));
            for (const MeshTreeKind kind : {MeshTreeKind::MedianKdTree, MeshTreeKind::SahKdTree,
                                            MeshTreeKind::WideKdTree, MeshTreeKind::WideBvh}) {
                const MeshTreeSize size = plantMeshTree(kind, mesh)->size();
                EXPECT_LE(size.depth, deepestKdTree(mesh->triangles.size())) << set.name << ", " << name(kind);
                EXPECT_LE(size.references, 24 * mesh->triangles.size()) << set.name << ", " << name(kind);
            }
        }
    }
}

std::vector<std::shared_ptr<const Shape>> manyShapes(std::uint64_t seed, int count) {
    std::vector<std::shared_ptr<const Shape>> shapes;
    const auto mesh = std::make_shared<const TriangleMesh>(bumpySphere(200));
    for (int i = 0; i < count; ++i) {
        Random random(seed, {static_cast<std::uint64_t>(i)});
        const Vec3 place = 5 * inCube(random);
        if (i % 3 == 0) {
            shapes.push_back(std::make_shared<Sphere>(place, random.uniform(0.1, 1)));
        } else {
            const Transform transform = Transform::translation(place) *
                                        Transform::rotation(inCube(random).normalized(), random.uniform(0, 6)) *
                                        Transform::scaling(Vec3(random.uniform(0.2, 1), random.uniform(0.2, 1), 0.5));
            shapes.push_back(std::make_shared<Instance>(mesh, transform, i));
        }
    }
    shapes.push_back(std::make_shared<Plane>(Vec3(0, -5, 0), Vec3::UnitY()));
    return shapes;
}

// A Group asks everybody. The tree holds meshes with trees of their own, and stands in an instance in another tree.
TEST(ShapeTree, TreesInTreesAgreeWithGroups) {
    const auto shapes = manyShapes(1, 60);
    const auto tree = std::make_shared<ShapeTree>(shapes);
    const auto group = std::make_shared<Group>(shapes);
    const Transform turn = Transform::rotation(Vec3(1, 2, 3).normalized(), 0.7) * Transform::scaling(Vec3(1, 2, -1));
    const auto sphere = std::make_shared<Sphere>(Vec3(0, 9, 0), 2.0);
    const ShapeTree outerTree({std::make_shared<Instance>(tree, turn), sphere});
    const Group outerGroup({std::make_shared<Instance>(group, turn), sphere});
    int hits = 0;
    for (std::uint64_t i = 0; i < 20'000; ++i) {
        Random random(2, {i});
        const Ray ray = {12 * inCube(random), inCube(random)};
        const auto expected = outerGroup.intersect(ray);
        const auto found = outerTree.intersect(ray);
        ASSERT_EQ(found.has_value(), expected.has_value());
        ASSERT_EQ(outerTree.occluded(ray), expected.has_value());
        if (!found) continue;
        ++hits;
        ASSERT_EQ(found->t, expected->t);
        ASSERT_EQ(found->object, expected->object);
        ASSERT_EQ(found->point, expected->point);
    }
    EXPECT_GT(hits, 5000);
    EXPECT_FALSE(tree->bounded()) << "the plane makes it infinite";
    EXPECT_TRUE(ShapeTree({sphere}).bounded());
}

}  // namespace
}  // namespace caustic
