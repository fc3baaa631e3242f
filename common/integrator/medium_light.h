#pragma once

#include "integrator/light_choice.h"
#include "scene/scene.h"

namespace caustic {

/// Radiance that the medium along a piece of a ray scatters to where the piece begins, of light that comes straight
/// from the lamps: single scattering. An estimate from some places of the piece, picked by equi-angular sampling around
/// points of lamps, one in each of equal shares of the angle; for lamps that are infinitely far away, by the medium.
///
/// Source: Kulla, Fajardo 2012.
/// @param span     where
/// @param places   at least 1
/// @param vertex   which vertex of the path lies in the medium, from 0: whose numbers are taken
/// @param numbers  the path's
/// @param counts   what is done in the scene is added
/// @return W/(m²·sr)
Color scatteredEquiAngular(const Scene& scene, const LightChoice& lights, const MediumSpan& span, int places,
                           int vertex, const PathNumbers& numbers, RayCounts& counts);

/// The same by ray marching: a sum over the middles of equal steps. What is narrower than a step is missed, or counts
/// too much: biased, and the same in every pass but for the choice of lamps and of points on them.
/// @param steps  at least 1
/// @throws InputError when the piece has no end
Color scatteredByMarching(const Scene& scene, const LightChoice& lights, const MediumSpan& span, int steps, int vertex,
                          const PathNumbers& numbers, RayCounts& counts);

}  // namespace caustic
