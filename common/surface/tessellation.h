#pragma once

#include "curve/bezier_patch.h"
#include "surface/indexed_triangles.h"
#include "surface/surface_of_revolution.h"

namespace caustic {

/// Triangles no point of which is farther than `tolerance` from the surface, nor any point of the surface from them.
///
/// The error of linear interpolation over a grid of m × n cells is at most (A/m² + 2 B/(m n) + C/n²) / 8, with A, B, C
/// bounds of the second derivatives by uu, uv and vv (Filip, Magedson, Markot 1986).
/// @throws InputError when the tolerance is not greater than 0, or so small that it takes more than 2^24 triangles
IndexedTriangles tessellated(const BezierPatch& patch, Real tolerance);

/// The same for a surface of revolution: half of the tolerance for the profile's chords, half for the polygon around
/// the axis. Segments share their joints' vertices, and what lies on the axis is one vertex.
IndexedTriangles tessellated(const SurfaceOfRevolution& surface, Real tolerance);

}  // namespace caustic
