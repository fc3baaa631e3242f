#include "mesh_command.h"

#include <cstdio>

#include "core/progress.h"
#include "figures/picture.h"
#include "image/image_file.h"
#include "material/diffuse_material.h"
#include "material/mirror_material.h"
#include "mesh_shape.h"
#include "scenes.h"

namespace caustic {

namespace {

SceneObject objectOf(const std::string& material, const std::string& file) {
    if (material == "diffuse")
        return {.shape = loadShape(file), .material = std::make_shared<DiffuseMaterial>(Color(0.75, 0.6, 0.4))};
    if (material == "mirror")
        return {.shape = loadShape(file), .material = std::make_shared<MirrorMaterial>(Color::Constant(0.92))};

    SceneObject glass = {.shape = loadShape(file), .material = clearGlass()};
    // Coloured as the report's bunny is, whatever the size of the mesh.
    const Real size = glass.shape->bounds().diagonal().norm() / 2;
    glass.interior = glassOf(Color(0.2, 0.75, 0.3).pow(1 / size));
    return glass;
}

}  // namespace

void renderMesh(const std::string& file, const std::string& material, const ChapterInputs& inputs,
                const ChapterOptions& options) {
    const SceneObject object = objectOf(material, file);
    Progress progress("mesh");
    FigureContext context(inputs, options, progress);
    const int side = context.byQuality(400, 800);
    const SceneDescription scene = meshScene(object, side, side);
    const Image picture = takePicture(
        scene, {context.byQuality(2, 5), {.maxDepth = 10, .leastWeight = 1e-3, .shadowSamples = 2}}, context);
    const auto path = context.output("mesh.png");
    saveImage(path, picture);
    std::printf("%s\n", path.c_str());
}

}  // namespace caustic
