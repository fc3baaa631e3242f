#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "image/image.h"
#include "modeler/diffuse_box.h"
#include "scene/scene.h"

namespace caustic {

/// A scene in which the methods' errors are measured; its pictures are square.
struct MeasuredScene {
    std::string name;                                 ///< as --scene and work.json call it: "diffuse_box"
    std::string title;                                ///< as charts call it: "diffuse box"
    int width;                                        ///< of its picture for --time, pixels
    int mostSegments;                                 ///< of a path from the eye to the light
    std::function<SceneDescription(int width)> make;  ///< what it is made of

    /// The picture as it should be, when it can be computed at once; otherwise it is committed.
    std::function<Image(int width, int threads)> compute;

    std::string asset;  ///< the committed reference, below the top of the repository; empty for none
    std::string judge;  ///< what made the reference, in a few words
};

/// The diffuse box with a small lamp and a mirror for its left wall.
DiffuseBox smallLampBox();

/// All of them: a diffuse box, the same with a small lamp and a mirror, a caustic on a floor, and the peers' box.
const std::vector<MeasuredScene>& measuredScenes();

/// Their names.
std::vector<std::string> measuredSceneNames();

/// The one of that name.
/// @throws InputError when there is none
const MeasuredScene& measuredScene(const std::string& name);

/// The picture as it should be: computed, or read from a file and shrunk.
/// @param width  of the picture; must divide the committed one's
/// @param file   the committed reference, where the scene has one
Image referenceOf(const MeasuredScene& scene, int width, const std::filesystem::path& file, int threads);

/// A picture made smaller: each pixel is the mean of the block that it takes the place of.
/// @throws InputError unless the width is a divisor of the picture's
Image shrunk(const Image& picture, int width);

}  // namespace caustic
