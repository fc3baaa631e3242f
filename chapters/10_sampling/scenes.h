#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "integrator/picture.h"
#include "scene/scene.h"

namespace caustic {

/// A scene that is hard here and easy there, and the method that renders it.
struct Study {
    std::string name;   ///< as --render calls it
    std::string title;  ///< as figures call it
    PictureTone tone;   ///< of its picture
    Real aspect;        ///< height of its picture over its width
    /// Files that it is made of, below the top of the repository; empty for none.
    std::string asset;
    std::function<SceneDescription(const std::string& file, int width, int height)> make;
    std::function<std::unique_ptr<Integrator>(const Scene& scene, const Sampler& sampler)> method;

    /// The scene, for a picture of that width.
    /// @param file  the asset's place
    Scene scene(const std::string& file, int width) const;
};

/// All of them: chapter 05's bunny of green glass by its ray tracer, the peers' box by path tracing, chapter 09's glass
/// of wine by SPPM.
const std::vector<Study>& studies();

/// What they are called.
std::vector<std::string> studyNames();

/// The one of that name.
/// @throws InputError when there is none
const Study& study(const std::string& name);

/// Where a study's asset is, as a figure asks for it; empty when it has none.
std::string assetOf(const Study& study, FigureContext& context);

}  // namespace caustic
