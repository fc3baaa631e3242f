#pragma once

#include <string>

#include "figure/figure.h"

namespace caustic {

/// Renders a scene that has a converged picture, each method so long in one thread, prints the errors and writes them
/// to
/// `<out>/09_sppm/timed_SCENE.csv`; pixels within 2 of a lamp left out.
/// @param name     "peers_box", "point_box" or "mirror_caustic"
/// @param seconds  of each method
/// @param methods  "photons" for both rules of SPPM and photon mapping, or "all"
/// @throws InputError when there is no such scene, or seconds isn't greater than 0
void timeMethods(const std::string& name, double seconds, const std::string& methods, const ChapterInputs& chapter,
                 const ChapterOptions& options);

}  // namespace caustic
