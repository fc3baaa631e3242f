#include <string>
#include <vector>

#include "chapter_inputs.h"
#include "core/chapter.h"
#include "figures.h"
#include "mesh_command.h"

namespace {

// Takes "--material M" out of the arguments, which runChapter doesn't know: it belongs to --mesh.
std::string takeMaterial(std::vector<const char*>& arguments) {
    for (std::size_t i = 1; i + 1 < arguments.size(); ++i) {
        if (std::string(arguments[i]) != "--material") continue;
        const std::string material = arguments[i + 1];
        const auto place = arguments.begin() + static_cast<std::ptrdiff_t>(i);
        arguments.erase(place, place + 2);
        return material;
    }
    return "glass";
}

}  // namespace

int main(int argc, char** argv) {
    using namespace caustic;
    std::vector<const char*> arguments(argv, argv + argc);
    const std::string material = takeMaterial(arguments);
    return runChapter(
        thisChapter, static_cast<int>(arguments.size()), arguments.data(),
        {
            {"materials", drawMaterials},
            {"beer_lambert", drawBeerLambert},
            {"shadows", drawShadows},
            {"box", drawBox},
            {"depth", drawDepth},
            {"speed_accuracy", chartSpeedAccuracy, true},
            {"failure", chartFailures},
            {"quantity", tabulateQuantities},
        },
        {
            {"--mesh", "FILE", "Render a mesh on a floor; with --material glass (the default), diffuse or mirror",
             [&material](const std::string& file, const ChapterOptions& options) {
                 renderMesh(file, material, thisChapter, options);
             }},
        });
}
