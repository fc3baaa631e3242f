#pragma once

#include <string>

#include "figure/figure.h"

namespace caustic {

/// Makes one of the converged pictures that errors are measured against and writes it to assets/references/: the peers'
/// box and the caustic before a mirror by bidirectional path tracing, the caustic on the floor by causticReference.
/// Says how far two independent halves of it are apart.
/// @param picture  "peers_box", "caustic_mirror" or "caustic_floor"
/// @param minutes  on the wall that it may take, as the user wrote them
/// @throws InputError when there is no such picture or minutes is no positive number
void makeReference(const std::string& picture, const std::string& minutes, const ChapterInputs& chapter,
                   const ChapterOptions& options);

}  // namespace caustic
