#pragma once

#include <string>
#include <vector>

#include "figure/figure.h"

namespace caustic {

/// The names of the pictures that makeReference can make: "peers_box", "caustic_mirror", "caustic_floor".
std::vector<std::string> referenceNames();

/// Makes one of the converged pictures that errors are measured against and writes it to assets/references/: the peers'
/// box and the caustic before a mirror by bidirectional path tracing, the caustic on the floor by causticReference.
/// Says how far two independent halves of it are apart.
/// @param picture  one of referenceNames()
/// @param minutes  on the wall that it may take, greater than 0
/// @throws InputError when there is no such picture
void makeReference(const std::string& picture, double minutes, const ChapterInputs& chapter,
                   const ChapterOptions& options);

}  // namespace caustic
