#pragma once

#include <string>

#include "figure/figure.h"

namespace caustic {

/// Makes one of the converged pictures that errors are measured against and writes it to assets/references/: SPPM by
/// rule ①, two halves of it with numbers of their own. Says how far the halves are apart.
/// Takes about `minutes` on the wall, greater than 0; the picture is "peers_box" or "point_box".
/// @throws InputError when there is no such picture
void makeReference(const std::string& picture, double minutes, const ChapterInputs& chapter,
                   const ChapterOptions& options);

}  // namespace caustic
