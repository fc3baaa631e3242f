#pragma once

#include <string>

#include "figure/figure.h"

namespace caustic {

/// Makes one of the converged pictures that errors are measured against and writes it to assets/references/: SPPM by
/// rule ①, two halves of it with numbers of their own. Says how far the halves are apart.
/// @param name     "peers_box" or "point_box"
/// @param minutes  on the wall that it may take
/// @throws InputError when there is no such picture or minutes isn't greater than 0
void makeReference(const std::string& name, double minutes, const ChapterInputs& chapter,
                   const ChapterOptions& options);

}  // namespace caustic
