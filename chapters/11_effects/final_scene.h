#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "scene/scene_description.h"

namespace caustic {

/// What of this chapter the final picture has; without, it is what earlier chapters could do.
struct FinalParts {
    bool environment = true;  ///< a panorama around; else an even glow of the same mean
    bool textures = true;     ///< a table of wood and a window with leads; else one colour each
    bool normals = true;      ///< a fluted glass and a hammered teapot; else smooth ones
    bool lens = true;         ///< else a pinhole
    bool fog = true;          ///< faint, so that the spotlight's cone is seen; else empty space
};

/// Finds an asset's file by its path below the repository.
using FindAsset = std::function<std::filesystem::path(const std::string& path)>;

/// The course's final picture: on a table of wood a glass of wine, a bunny of green glass, a copper teapot and marbles;
/// a window at the left, a spotlight behind, the evening around. y is up, all in metres.
/// @throws InputError when an asset is missing or damaged
SceneDescription finalScene(const FinalParts& parts, const FindAsset& asset, int width, int height);

}  // namespace caustic
