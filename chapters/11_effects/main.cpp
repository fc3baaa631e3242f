#include <string>

#include "chapter_inputs.h"
#include "figure/chapter.h"
#include "figures.h"
#include "final_command.h"
#include "scene_command.h"

int main(int argc, char** argv) {
    using namespace caustic;
    FinalWishes wishes;
    std::string scene;
    return runChapter(
        thisChapter, argc, argv,
        {
            {"environment", drawEnvironment},
            {"textures", drawTextures},
            {"normals", drawNormals},
            {"cup", drawCup},
            {"depth_of_field", drawDepthOfField},
            {"parts", drawParts},
            {"volume_light", drawVolumeLight},
            {"glow", drawGlow},
            {"speed_accuracy", chartSpeedAccuracy, true},
            {"failure", chartFailures},
            {"quantity", tabulateQuantities, true},
        },
        {
            {.argument = {"--final", "WIDTH", "Render the course's final picture",
                          RangedValue<std::int64_t>{&wishes.width, 16, 16384}},
             .run = [&](const ChapterOptions& options) { renderFinal(wishes, thisChapter, options); },
             .uses = {"--out", "--threads", "--seed"},
             .options = {{"--passes", "N", "Passes in all", RangedValue<std::int64_t>{&wishes.passes, 1, 1'000'000}},
                         {"--photons", "N", "Photons a pass", RangedValue<std::int64_t>{&wishes.photons, 1, 1 << 30}},
                         {"--checkpoint", "FILE", "Go on from this file when it is there, and write it",
                          TextValue{&wishes.checkpoint}},
                         {"--every", "N", "Passes between two checkpoints",
                          RangedValue<std::int64_t>{&wishes.every, 1, 1'000'000}}}},
            {.argument = {"--scene", "FILE", "Render a scene of your own (docs/scenes.md)", TextValue{&scene}},
             .run = [&](const ChapterOptions& options) { renderOwnScene(scene, thisChapter, options); },
             .uses = {"--out", "--threads", "--seed"},
             .options = {}},
        });
}
