#pragma once

#include <functional>
#include <string>
#include <vector>

#include "integrator/sppm.h"
#include "scene/scene_description.h"

namespace caustic {

/// The drawing of the wine glass, below the top of the repository.
inline constexpr const char* glassProfile = "assets/profiles/wine_glass.svg";

/// A scene that this chapter renders.
struct NamedScene {
    std::string name;       ///< as --render calls it
    int width;              ///< pixels of its picture
    int height;             ///< rows of it
    Real exposure;          ///< before tone mapping
    SppmSettings settings;  ///< that suit it
    /// Makes it; those with a glass read its drawing from the file.
    std::function<SceneDescription(int width, int height, const std::string& glass)> make;
};

/// All of them.
const std::vector<NamedScene>& namedScenes();

/// What they are called.
std::vector<std::string> sceneNames();

/// The one of that name.
/// @throws InputError when there is none
const NamedScene& namedScene(const std::string& name);

/// The peers' box with a point for a lamp: 70 W at (0, −0.5, 1), all else the same.
SceneDescription pointLitBox(int width, int height);

/// A glass of red wine on a table, a spotlight behind it, a window at the side.
/// @param file   the drawing of the glass
/// @param wine   whether there is any in it
SceneDescription wineGlassScene(const std::string& file, bool wine, int width, int height);

}  // namespace caustic
