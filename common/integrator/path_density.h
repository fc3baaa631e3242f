#pragma once

#include "math/real.h"

namespace caustic {

/// How a vertex of a walk was left. A delta lobe has the same probability from either side, and each ratio of densities
/// goes through it as 1: both are 1 there.
struct VertexPdf {
    Real forward = 1;  ///< density over solid angle, 1/sr, with which the walk went on from the vertex
    Real reverse = 1;  ///< the same with which a walk from the other end would go back from it

    /// Whether a walk, this one or the other, may end at the vertex and be connected to the end of another one: not
    /// where a delta lobe scatters, nor at an eye that splats nothing. That closes two strategies: the one that ends
    /// this walk here, and the one that ends the other walk here. Its densities of 1 are over solid angle; over area
    /// they take cosine and distance as any others.
    bool connectible = true;
};

/// A segment of a path, from one vertex to the next one.
struct Segment {
    Real cosFrom = 1;  ///< |cosine| between the segment and ng of the vertex that it leaves; 1 for a point in space
    Real cosTo = 1;    ///< the same for the vertex that it arrives at
    Real squaredDistance = 1;  ///< m²; 1 for a segment from or to infinity
};

/// What the weights of bidirectional path tracing need to know of a walk, at its last vertex.
///
/// A path x_0 … x_k of which s vertices come from the light has the density p_s = Π p→(x_i) (i < s) · Π p←(x_i) (i ≥
/// s), where p→ and p← are the densities over area with which a walk from the light, and one from the eye, picks the
/// vertex. Neighbouring strategies differ in one factor: p_{s+1}/p_s = p→(x_s)/p←(x_s) (Veach 1997, eq. 10.9). So the
/// sum over all strategies that take fewer vertices from this walk is gathered while it is walked: each weight then
/// takes the same few operations, however long the path is. Everything is squared, for the power heuristic. The same
/// struct serves both ends; for a walk from the eye, swap the arrows.
/// Source: Georgiev 2012, Implementing Vertex Connection and Merging, eq. 34 to 37, whose names these are; without
/// merging.
struct PathDensity {
    /// The strategy in which this walk ends one vertex earlier and the other one at this vertex: 1/p→² of this vertex,
    /// over area (over solid angle for one at infinity); 0 where there is no such strategy. At a walk's first vertex:
    /// the other walk hits it by chance.
    Real dVCM = 0;

    /// The sum over all strategies in which this walk ends earlier still, each squared density over that of the one
    /// in which it ends here, but for two factors that PathDensity::others adds: p← of this vertex, and the density
    /// over solid angle of going from here back to the vertex before, both squared.
    Real dVC = 0;

    /// At a walk's first vertex.
    /// @param pdf       density with which it was picked, over area; over solid angle at infinity
    /// @param canBeHit  whether a walk from the other end finds it by chance: no point in space, no pinhole
    static PathDensity start(Real pdf, bool canBeHit) { return {canBeHit ? 1 / (pdf * pdf) : 0, 0}; }

    /// At the next vertex.
    /// @param left     how this one is left
    /// @param segment  from this one to the next; cosTo / squaredDistance turns a density over solid angle here into
    ///                 one over area there, cosFrom / squaredDistance one there into one here
    PathDensity next(const VertexPdf& left, const Segment& segment) const;

    /// Sum of the squared densities of all strategies in which this walk ends earlier, over the squared density of the
    /// one in which it ends here.
    /// @param reverse      p← of this vertex, over area as its p→ is (over solid angle for one at infinity)
    /// @param reversePdfW  density over solid angle with which the other walk goes on from here to the vertex before,
    ///                     1/sr
    Real others(Real reverse, Real reversePdfW) const;
};

/// The weight of a strategy by the power heuristic, its squared density over the sum of those of all. Source: Veach
/// 1997, 10.2; Georgiev 2012, eq. 37.
/// @param fromLight  PathDensity::others of the light's walk; 0 when that is empty
/// @param fromEye    the same for the eye's
inline Real strategyWeight(Real fromLight, Real fromEye) { return 1 / (1 + fromLight + fromEye); }

}  // namespace caustic
