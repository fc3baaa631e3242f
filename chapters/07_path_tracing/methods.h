#pragma once

#include <array>
#include <memory>
#include <string>

#include "integrator/integrator.h"

namespace caustic {

/// The five methods of this chapter.
enum class Method {
    Chance,        ///< path tracing that finds lamps by chance
    Direct,        ///< path tracing that asks lamps at each surface
    Mis,           ///< path tracing that does both and weighs them
    Light,         ///< light tracing
    Bidirectional  ///< bidirectional path tracing
};

/// All of them, in the order in which the lesson tells of them.
inline constexpr std::array allMethods = {Method::Chance, Method::Direct, Method::Mis, Method::Light,
                                          Method::Bidirectional};

/// What tables and charts call it: "path tracing with MIS".
std::string nameOf(Method method);

/// Makes the integrator of a method, with the chapter's usual roulette.
/// @param mostSegments  of a path from the eye to the light, at least 1
std::unique_ptr<Integrator> makeIntegrator(Method method, const Scene& scene, const Sampler& sampler,
                                           const PixelFilter& filter, int mostSegments);

}  // namespace caustic
