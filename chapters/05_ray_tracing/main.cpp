#include <string>

#include "chapter_inputs.h"
#include "figure/chapter.h"
#include "figures.h"
#include "mesh_command.h"

int main(int argc, char** argv) {
    using namespace caustic;
    std::string mesh;
    std::string material = "glass";
    return runChapter(
        thisChapter, argc, argv,
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
            {.argument = {"--mesh", "FILE", "Render a mesh on a floor", TextValue{&mesh}},
             .run = [&](const ChapterOptions& options) { renderMesh(mesh, material, thisChapter, options); },
             .uses = {"--out", "--quality", "--threads", "--seed"},
             .options = {{"--material", "NAME", "What it is made of",
                          ChoiceValue{&material, {"glass", "diffuse", "mirror"}}}}},
        });
}
