#pragma once

#include <array>
#include <memory>
#include <string>

#include "integrator/sppm.h"

namespace caustic {

/// What SPPM is held against.
enum class Method {
    Path,           ///< path tracing with MIS
    Bidirectional,  ///< bidirectional path tracing
    PhotonMap,      ///< one photon map of a fixed radius and all photons of SPPM's passes
    Pass,           ///< SPPM by rule ①
    Point           ///< SPPM by rule ②
};

/// All of them, in the order in which charts name them.
inline constexpr std::array allMethods = {Method::Path, Method::Bidirectional, Method::PhotonMap, Method::Pass,
                                          Method::Point};

/// Whether it is one of those that trace photons.
inline bool tracesPhotons(Method method) { return method != Method::Path && method != Method::Bidirectional; }

/// What tables and charts call it.
std::string nameOf(Method method);

/// A method's integrator, with the numbers that it takes. Passes of `photon mapping` are those of SPPM with a radius
/// that stays.
std::unique_ptr<Integrator> makeIntegrator(Method method, const Scene& scene, const Sampler& sampler,
                                           const PixelFilter& filter, const SppmSettings& settings);

}  // namespace caustic
