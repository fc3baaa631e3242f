#include <array>
#include <string>

#include "core/progress.h"
#include "figures.h"
#include "figures/mesh_view.h"
#include "image/drawing.h"
#include "mesh/mesh_file.h"
#include "mesh/triangle_mesh.h"
#include "mesh/vertex_normals.h"

namespace caustic {

void drawBunnies(FigureContext& context) {
    constexpr int tile = 420;
    constexpr int gap = 14;
    constexpr int top = 64;
    constexpr int left = 130;
    const std::array<std::string, 2> files = {"assets/meshes/bunny_low.obj", "assets/meshes/bunny.ply"};
    Drawing drawing(left + 2 * (tile + gap), top + 2 * (tile + gap));
    context.progress().expect(4);
    for (int column = 0; column < 2; ++column) {
        const MeshData mesh = loadMesh(context.asset(files[static_cast<std::size_t>(column)]));
        const Real x = left + column * (tile + gap);
        drawing.text({x + tile / 2.0, top - 20.0}, std::to_string(mesh.triangles.size()) + " triangles",
                     {.size = 22, .horizontal = HorizontalAnchor::Centre});
        for (int row = 0; row < 2; ++row) {
            const TriangleMesh shape(row == 0 ? mesh : withVertexNormals(mesh, NormalWeight::Angle));
            const auto color = [&](const Ray& ray) {
                const auto hit = shape.intersect(ray);
                return hit ? plaster(*hit, -ray.direction) : paperColor();
            };
            RayView view = viewOf(shape.bounds(), Vec3(0.25, 0.3, 1));
            view.height *= 1.06;  // so that the feet stand above the edge
            const Image image = supersampled(view, tile, tile, context.byQuality(2, 5), color, context.threads());
            const Vec2 corner(x, top + row * (tile + gap));
            drawing.image(image, {corner, corner + Vec2(tile, tile)});
            context.progress().advance();
        }
    }
    const std::array<std::array<std::string, 2>, 2> rows = {
        {{"flat", "normal of the face"}, {"smooth", "interpolated"}}};
    for (int row = 0; row < 2; ++row) {
        const Real y = top + row * (tile + gap) + tile / 2.0;
        drawing.text({12, y - 12}, rows[static_cast<std::size_t>(row)][0], {.size = 22});
        drawing.text({12, y + 14}, rows[static_cast<std::size_t>(row)][1], {.size = 12});
    }
    drawing.save(context.output("bunnies.png"));
}

}  // namespace caustic
