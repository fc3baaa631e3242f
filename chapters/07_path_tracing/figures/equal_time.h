#pragma once

#include <functional>
#include <string>
#include <vector>

#include "figures.h"
#include "scene/scene_description.h"

namespace caustic {

/// A picture that all five methods take in the same time, each with the work that work.json says.
struct EqualTimePicture {
    std::string name;                        ///< of the figure, and in work.json
    int width;                               ///< pixels of one of the pictures
    int height;                              ///< rows of it
    int mostSegments;                        ///< of a path from the eye to the light
    Real exposure;                           ///< before tone mapping
    std::function<SceneDescription()> make;  ///< what it shows
    std::string asset;                       ///< the converged picture, below the top of the repository
    std::string converged;                   ///< its caption
};

/// methods.png and caustic.png.
const std::vector<EqualTimePicture>& equalTimePictures();

}  // namespace caustic
