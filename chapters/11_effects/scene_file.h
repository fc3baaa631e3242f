#pragma once

#include <string>

#include "integrator/picture.h"
#include "integrator/render.h"
#include "scene/scene_description.h"

namespace caustic {

/// How a scene of one's own is to be rendered.
struct SceneMethod {
    std::string type;       ///< "path", "light", "bidirectional", "photons" or "fog"
    int segments = 16;      ///< of a path, at most
    Real radius = 0;        ///< of photons on surfaces in the first pass, m; 0 for the usual one
    Real beamRadius = 0;    ///< of photons around rays, m; 0 for the same
    int photons = 1 << 16;  ///< a pass
    int places = 4;         ///< of direct light along each piece of a ray in fog
};

/// A scene of one's own: what docs/scenes.md describes.
struct SceneFile {
    SceneDescription description;
    SceneMethod method;
    RenderSettings limits;  ///< passes, seconds
    PictureTone tone;
};

/// Reads a scene from a JSON file. Files that it names are looked for from its folder.
/// @throws InputError with file and JSON pointer, for anything that isn't as docs/scene.schema.json has it, that is out
/// of
///         its range, or that a named file is wrong with
SceneFile loadScene(const std::string& file);

}  // namespace caustic
