#pragma once

#include <span>
#include <vector>

#include "math/color.h"
#include "math/vector.h"

namespace caustic {

/// How light has come from its lamp to where it is. Each photon has one of the three, so maps that are made of them are
/// complete together and count nothing twice.
enum class PhotonWay {
    Direct,   ///< straight
    Caustic,  ///< by delta lobes only: mirrors and smooth boundaries
    Indirect  ///< by at least one non-specular surface, or a medium
};

/// The way of light that is scattered once more.
/// @param way    before
/// @param delta  whether a delta lobe scatters it
PhotonWay scatteredWay(PhotonWay way, bool delta);

/// Light that has come to a surface.
struct Photon {
    Vec3 point = Vec3::Zero();    ///< where
    Vec3 wi = Vec3::UnitZ();      ///< unit direction to where it came from
    Color power = Color::Zero();  ///< that it brings, W
    Vec3 ng = Vec3::UnitZ();      ///< unit geometric normal of the surface
    int length = 0;               ///< segments from the lamp
    PhotonWay way = PhotonWay::Direct;
};

/// Where they are, in their order: what trees and grids of photons are made from.
std::vector<Vec3> pointsOf(std::span<const Photon> photons);

}  // namespace caustic
