#include <array>
#include <memory>
#include <string>

#include "core/progress.h"
#include "figures.h"
#include "image/drawing.h"
#include "image/view_transform.h"
#include "mesh/kd_mesh_tree.h"
#include "mesh/mesh_file.h"
#include "mesh_sets.h"

namespace caustic {

namespace {

constexpr int tile = 640;
constexpr int gap = 24;
constexpr int top = 70;

// The tree's cells where they meet the plane z = cut: its planes are the lines between them.
void drawCells(const KdNodes<Real>& tree, std::uint32_t index, const Bounds3& box, Real cut, const ViewTransform& view,
               Drawing& drawing) {
    if (cut < box.min().z() || cut > box.max().z()) return;
    const KdNode<Real>& node = tree.nodes[index];
    if (!node.isLeaf()) {
        Bounds3 lower = box;
        Bounds3 upper = box;
        lower.max()[node.axis] = node.plane;
        upper.min()[node.axis] = node.plane;
        drawCells(tree, node.first, lower, cut, view, drawing);
        drawCells(tree, node.first + 1, upper, cut, view, drawing);
        return;
    }
    const Vec2 a = view.toPixel(box.min().head<2>());
    const Vec2 b = view.toPixel(box.max().head<2>());
    const Bounds2 cell(a.cwiseMin(b), a.cwiseMax(b));
    if (node.count > 0) {
        const Real share = std::min(1.0, node.count / 8.0);
        drawing.rectangle(cell, palette::orange.withAlpha(0.15 + 0.6 * share));
    }
    drawing.rectangle(cell, Stroke{palette::blue, 1});
}

// Where the triangles meet the plane.
void drawSection(const MeshData& mesh, Real cut, const ViewTransform& view, Drawing& drawing) {
    for (std::uint32_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
        const auto corners = mesh.corners(triangle);
        std::vector<Vec2> crossings;
        for (std::size_t i = 0; i < 3; ++i) {
            const Vec3& a = corners[i];
            const Vec3& b = corners[(i + 1) % 3];
            if ((a.z() < cut) == (b.z() < cut)) continue;
            const Real share = (cut - a.z()) / (b.z() - a.z());
            crossings.push_back(view.toPixel(((1 - share) * a + share * b).head<2>()));
        }
        if (crossings.size() == 2) drawing.line(crossings[0], crossings[1], {palette::vermilion, 2.2});
    }
}

}  // namespace

void drawSplits(FigureContext& context) {
    const auto mesh = std::make_shared<const MeshData>(loadMesh(context.asset("assets/meshes/bunny_low.obj")));
    const std::array<KdRule, 2> rules = {KdRule{.split = KdSplit::Median}, KdRule{}};
    const std::array<std::string, 2> names = {"through the median", "surface area heuristic"};
    Drawing drawing(2 * (tile + gap) + gap, top + tile + gap);
    context.progress().expect(2);
    for (std::size_t i = 0; i < 2; ++i) {
        const KdMeshTree tree(mesh, rules[i]);
        const KdNodes<Real>& nodes = tree.tree().nodes();
        const Real x = gap + static_cast<Real>(i) * (tile + gap);
        const Bounds2 pixels(Vec2(x, top), Vec2(x + tile, top + tile));
        const Bounds2 world(nodes.box.min().head<2>(), nodes.box.max().head<2>());
        const ViewTransform view = ViewTransform::fit(world, pixels, 4);
        const Real cut = nodes.box.center().z() + 0.02 * nodes.box.diagonal().z();
        drawCells(nodes, 0, nodes.box, cut, view, drawing);
        drawSection(*mesh, cut, view, drawing);
        drawing.text({x + tile / 2.0, top - 38.0}, names[i], {.size = 24, .horizontal = HorizontalAnchor::Centre});
        drawing.text({x + tile / 2.0, top - 12.0},
                     std::to_string(nodes.nodes.size()) + " nodes, depth " + std::to_string(nodes.depth) + ", " +
                         std::to_string(nodes.items.size()) + " references to " +
                         std::to_string(mesh->triangles.size()) + " triangles",
                     {.size = 16, .horizontal = HorizontalAnchor::Centre});
        context.progress().advance();
    }
    drawing.save(context.output("splits.png"));
}

}  // namespace caustic
