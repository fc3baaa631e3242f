#pragma once

#include "math/real.h"

namespace caustic {

/// The densities with which a surface's scattering was sampled, per solid angle: onwards, and the other way round if
/// the path came from the other end. Both are 1 for a delta lobe, whose probability is the same from either side.
struct ScatteringPdf {
    Real onwards = 1;
    Real back = 1;
    bool delta = false;
};

/// A segment of a path, from one vertex to the next one.
struct Segment {
    Real cosFrom = 1;  ///< |cosine| between the segment and ng of the vertex that it leaves; 1 for a point in space
    Real cosTo = 1;    ///< the same for the vertex that it arrives at
    Real squaredDistance = 1;  ///< m²; 1 for a segment from or to infinity
};

/// What the weights of bidirectional path tracing need to know of a subpath, at its last vertex.
///
/// A path x_0 … x_k of which s vertices come from the light has the density p_s = Π p_L(x_i) (i < s) · Π p_E(x_i) (i ≥
/// s), where p_L and p_E are the densities over area with which a walk from the light, or from the eye, picks the
/// vertex from the two before it. Neighbouring strategies differ in one factor: p_{s+1}/p_s = p_L(x_s)/p_E(x_s) (Veach,
/// eq. 10.9). So strategies that take a vertex more from this end differ from each other by products of ratios along
/// this subpath, and the sum over all that take fewer is gathered while the path is walked: each weight then takes the
/// same few operations, however long the path is. Everything is squared, for the power heuristic. The same struct
/// serves both ends. Source: Veach 10.2, eq. 10.9 ff.; sums along the way: van Antwerpen 2011, Georgiev 2012.
struct PathDensity {
    /// With which this walk picked the vertex, over area; over solid angle for a vertex at infinity. Greater than 0.
    Real forward = 1;

    /// A density over solid angle at this vertex, of the direction to the one before, times this is that one's over
    /// area.
    Real toArea = 0;

    /// 1 if the other walk may end at this vertex while this one ends before it, else 0. For the first vertex: whether
    /// the other walk can hit it by chance.
    Real open = 1;

    /// Sum over the strategies in which this walk ends earlier still, of squared products of ratios, up to the factors
    /// that the next vertices decide.
    Real tail = 0;

    /// The density at the next vertex.
    /// @param pdf  how the last vertex scattered; for the first one how the walk set out
    PathDensity next(const ScatteringPdf& pdf, const Segment& segment) const;

    /// Sum of the squared densities of all strategies in which this walk ends earlier, over the squared density of the
    /// one in which it ends here.
    /// @param reverse  density with which the other walk picks this vertex, in the measure of `forward`
    /// @param back     density over solid angle with which it goes on from here to the vertex before, 1/sr
    Real others(Real reverse, Real back) const;
};

/// The weight of a strategy (power heuristic): its squared density over the sum of those of all strategies.
/// @param fromLight  PathDensity::others of the light's subpath; 0 when that is empty
/// @param fromEye    the same for the eye's
inline Real strategyWeight(Real fromLight, Real fromEye) { return 1 / (1 + fromLight + fromEye); }

}  // namespace caustic
