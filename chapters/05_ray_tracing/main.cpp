#include <string>
#include <vector>

#include "chapter_inputs.h"
#include "figure/chapter.h"
#include "figure/take_option.h"
#include "figures.h"
#include "mesh_command.h"

int main(int argc, char** argv) {
    using namespace caustic;
    std::vector<const char*> arguments(argv, argv + argc);
    const std::string material = takeOption(arguments, "--material", "glass");
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
