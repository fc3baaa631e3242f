#pragma once

#include "image/image.h"
#include "integrator/sppm.h"
#include "scene/scene_description.h"

namespace caustic {

/// The caustic of chapter 07 on its floor, seen in a small mirror that hangs in front of the camera: light that comes
/// to the eye over glass, a diffuse floor and a mirror, which no method that connects paths finds. The mirror is so
/// small that it throws no light back to speak of, and the picture is that of the floor, the other way round.
SceneDescription mirrorCaustic(int width);

/// What it should be: the picture of the bare floor, made by chapter 07's program for that scene alone, in a mirror.
/// @param floor  that picture, whose width `width` divides
Image mirrorCausticReference(const Image& floor, int width);

/// How SPPM renders it.
SppmSettings mirrorCausticSettings();

}  // namespace caustic
