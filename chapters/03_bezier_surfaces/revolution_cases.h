#pragma once

#include <string>
#include <vector>

#include "core/random.h"
#include "surface/surface_of_revolution.h"

namespace caustic {

/// A surface of revolution with a name.
struct NamedProfile {
    std::string name;
    std::vector<BezierCurve> profile;
};

/// Profiles that hold every difficulty: a vase, a degree of 12, cusps, negative radii, a cone, flat discs, a profile
/// that touches the axis, an open one.
std::vector<NamedProfile> difficultProfiles();

/// The cubic vase of four segments that timings use.
std::vector<BezierCurve> plainVase();

/// A family of rays at a surface.
struct RaySet {
    std::string name;
    Ray (*make)(const SurfaceOfRevolution& surface, Random& random);
};

/// Random chords first, then the adversarial sets: near and in the plane of rotation, near and along the axis, through
/// poles and joints, tangent, from afar, from on the surface, through the rims.
std::vector<RaySet> revolutionRaySets();

}  // namespace caustic
