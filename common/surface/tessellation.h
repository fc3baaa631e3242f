#pragma once

#include "surface/indexed_triangles.h"
#include "surface/surface_of_revolution.h"

namespace caustic {

/// Triangles no point of which is farther than `tolerance` from the surface, nor any point of the surface from them.
///
/// Half of the tolerance goes to the profile's chords, whose error is at most an eighth of the second derivative's
/// bound over the square of their number (Filip, Magedson, Markot 1986), half to the polygon around the axis. Segments
/// share their joints' vertices, and what lies on the axis is one vertex.
/// @throws InputError when the tolerance is not greater than 0, or so small that it takes more than 2^24 triangles
IndexedTriangles tessellated(const SurfaceOfRevolution& surface, Real tolerance);

}  // namespace caustic
