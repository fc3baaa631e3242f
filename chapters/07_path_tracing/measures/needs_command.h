#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "scene/scene_description.h"

namespace caustic {

/// A scene that needs something more than the one before it.
struct NeedyScene {
    std::string name;            ///< what it needs more: "point lamp", "area lamp" …
    SceneDescription (*make)();  ///< for a picture of 32 × 32 pixels
};

/// A diffuse room under a point lamp; an area lamp in its place; a mirror; a glass ball; absorption in it and a
/// checkered floor.
const std::vector<NeedyScene>& needyScenes();

/// Traces paths in one of them and nothing else, so that a profiler can count what they take.
/// @param scene    its number, from 0
/// @param method   number of the method among allMethods
/// @param samples  paths of each of its 1024 pixels, at least 1
void tracePaths(std::int64_t scene, std::int64_t method, std::int64_t samples);

}  // namespace caustic
