#pragma once

#include "camera/camera.h"
#include "sampling/sampler.h"
#include "scene/scene.h"

namespace caustic {

/// How a vertex of a light path is seen by the camera.
struct CameraConnection {
    ImportanceSample camera;      ///< where on the film, and which way it lies
    Color value = Color::Zero();  ///< what the pixels around get, divided by all densities already, if no other way to
                                  ///< make the path is weighed against it
};

/// Connects a vertex of a light path to the camera. A specular surface is never seen this way: its one direction
/// doesn't lead into the pinhole. f is that for importance; the shadow ray leads from the vertex to the lens point, and
/// starts in the media on its side of the vertex.
/// @param at       connectible()
/// @param beta     throughput of the light path at the vertex, W
/// @param vertex   which vertex of the path it is, from 0: its Lens numbers are taken
/// @param numbers  the light path's: a lens takes a pair
/// @param counts   what is done in the scene is added
/// @return nothing when it isn't on the film, or all three channels of what gets there are 0: something is in the
///         way, or no light goes there
std::optional<CameraConnection> connectToCamera(const Scene& scene, const Interaction& at, const Color& beta,
                                                int vertex, const PathNumbers& numbers, RayCounts& counts);

}  // namespace caustic
