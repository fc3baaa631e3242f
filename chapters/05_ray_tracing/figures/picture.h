#pragma once

#include "integrator/picture.h"
#include "integrator/ray_tracer.h"

namespace caustic {

/// How a picture is taken.
struct PictureSettings {
    int perAxis = 2;           ///< this squared is the number of paths a pixel
    RayTracerSettings tracer;  ///< how far and how fine
    PictureTone tone = {.exposure = 1.7};
};

/// Renders a scene by recursive ray tracing and tone-maps it.
/// @throws std::runtime_error when a sample was no finite number
Image takePicture(const SceneDescription& scene, const PictureSettings& settings, FigureContext& context);

}  // namespace caustic
