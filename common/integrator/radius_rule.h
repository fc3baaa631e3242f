#pragma once

#include <cstdint>

#include "math/color.h"

namespace caustic {

/// How the radius within which photons count gets smaller from pass to pass, so that blur and noise both vanish.
enum class RadiusRule {
    Pass,  ///< for all points alike, by the pass number: the report's rule ①, made consistent by Knaus and Zwicker
    Point  ///< for each pixel, by the photons that it has found: the report's rule ②, Hachisuka and Jensen's
};

/// Rule ①: the radius of a pass, R_i² = R_0² ∏ (k + α)/(k + 1) over k = 1 ... i. So variance grows by a factor less
/// than what more passes take from it, and the mean over the passes has no bias left in the end: its variance goes as
/// 1/i^α, its bias as 1/i^(1 − α). Source: Knaus, Zwicker 2011, Progressive Photon Mapping: A Probabilistic Approach,
/// ACM TOG 30(3), eqs. 15 and 17.
/// @param first  R_0, m
/// @param alpha  in (0, 1)
/// @param pass   i, from 0
Real radiusOfPass(Real first, Real alpha, std::int64_t pass);

/// What rule ② keeps of a pixel.
struct PointStatistics {
    Real radius = 0;             ///< R, m
    Real photons = 0;            ///< N: photons that count as found so far
    Color flux = Color::Zero();  ///< τ: what they bring within R, sum over passes, W/sr
};

/// What one pass finds at a visible point.
struct Gathered {
    std::int64_t photons = 0;    ///< M: how many that scatter towards the eye
    Color flux = Color::Zero();  ///< what they bring, W/sr: radiance times area
};

/// Rule ②: the pixel keeps the share α of the photons that a pass adds, and shrinks its disc so that their density
/// stays what it was: R' = R √((N + αM)/(N + M)), τ' = (τ + found) R'²/R². Source: Hachisuka, Ogaki, Jensen 2008, eqs.
/// 8 to 11; a pixel's points of all passes share it: Hachisuka, Jensen 2009, eqs. 8 and 9.
/// @param alpha  in (0, 1)
void update(PointStatistics& pixel, const Gathered& found, Real alpha);

}  // namespace caustic
