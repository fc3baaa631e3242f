#pragma once

#include <vector>

#include "figure/failures.h"

namespace caustic {

/// Kinds of cases in media: where marching, photons along rays and free flights break.
std::vector<FailureKind> volumeKinds();

}  // namespace caustic
