#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <memory>
#include <vector>

#include "core/parallel.h"
#include "mesh/mesh_file.h"
#include "mesh/mesh_tree.h"
#include "mesh_sets.h"
#include "support/paths.h"

namespace caustic {
namespace {

constexpr int threads = 2;

std::vector<std::unique_ptr<const MeshTree>> treesOver(const std::shared_ptr<const MeshData>& mesh) {
    std::vector<std::unique_ptr<const MeshTree>> trees;
    for (const MeshTreeKind kind : allMeshTrees) {
        if (kind != MeshTreeKind::BruteForce) trees.push_back(plantMeshTree(kind, mesh));
    }
    return trees;
}

// Rays that a tree answers in another way than the judge, exact ties aside; for any hit, in another way than itself.
std::int64_t differences(const MeshData& mesh, const MeshTree& judge,
                         const std::vector<std::unique_ptr<const MeshTree>>& trees, std::uint64_t seed,
                         std::int64_t rays) {
    constexpr std::int64_t batch = 1000;
    const Bounds3 box = boundsOf(mesh);
    std::atomic<std::int64_t> count = 0;
    parallelFor(rays / batch, threads, [&](std::int64_t number) {
        Random random(seed, {static_cast<std::uint64_t>(number)});
        for (std::int64_t i = 0; i < batch; ++i) {
            const Ray ray = i % 2 == 0 ? randomRayAt(mesh, box, random) : randomChord(box, random);
            const auto truth = judge.intersect(ray);
            for (const auto& tree : trees) {
                const auto found = tree->intersect(ray);
                const bool same = found.has_value() == truth.has_value() && (!found || found->t == truth->t);
                count += same && tree->occluded(ray) == truth.has_value() ? 0 : 1;
            }
        }
    });
    return count;
}

// Ten million rays at meshes of every kind of badness, up to a thousand triangles. Brute force is the definition.
TEST(LargeMeshTrees, AgreeWithBruteForceOnEverySet) {
    constexpr std::array<std::uint32_t, 4> sizes = {10, 50, 200, 1000};
    constexpr std::array<std::int64_t, 4> rays = {4'000'000, 3'000'000, 2'000'000, 1'000'000};
    for (const MeshSet& set : meshSets()) {
        for (std::size_t i = 0; i < sizes.size(); ++i) {
            Random maker(21, {i});
            const auto mesh = std::make_shared<const MeshData>(set.make(maker, sizes[i]));
            const auto brute = plantMeshTree(MeshTreeKind::BruteForce, mesh);
            EXPECT_EQ(differences(*mesh, *brute, treesOver(mesh), 22 + i, rays[i]), 0)
                << set.name << ", " << sizes[i] << " triangles";
        }
    }
}

// A scanned mesh: a hundred thousand rays by brute force, ten million by all trees against each other.
TEST(LargeMeshTrees, AgreeOnTheBunny) {
    const auto mesh = std::make_shared<const MeshData>(loadMesh(test::sourceDir() / "assets/meshes/bunny.ply"));
    const auto trees = treesOver(mesh);
    const auto brute = plantMeshTree(MeshTreeKind::BruteForce, mesh);
    EXPECT_EQ(differences(*mesh, *brute, trees, 31, 100'000), 0);
    EXPECT_EQ(differences(*mesh, *trees.front(), trees, 32, 10'000'000), 0);
}

}  // namespace
}  // namespace caustic
