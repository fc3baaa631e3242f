#pragma once

#include <vector>

#include "figure/failures.h"

namespace caustic {

/// Kinds of cases of maps and lenses: where normal maps, densities over panoramas and cameras of the books break.
std::vector<FailureKind> mapKinds();

}  // namespace caustic
