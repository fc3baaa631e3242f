#pragma once

#include "figure/figure.h"
#include "image/image.h"
#include "integrator/ray_tracer.h"

namespace caustic {

/// How a picture is taken.
struct PictureSettings {
    int perAxis = 2;           ///< this squared is the number of paths a pixel
    RayTracerSettings tracer;  ///< how far and how fine
    Real exposure = 1.7;       ///< before tone mapping
    Real white = 4;            ///< what is shown as white
};

/// Renders a scene by recursive ray tracing and tone-maps it.
/// @throws std::runtime_error when a sample was no finite number
Image takePicture(const SceneDescription& scene, const PictureSettings& settings, FigureContext& context);

}  // namespace caustic
