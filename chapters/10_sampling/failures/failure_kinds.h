#pragma once

#include <vector>

#include "figure/failures.h"

namespace caustic {

/// What grids, rules and stopping get wrong that the chapter's own ways get right.
std::vector<FailureKind> samplingFailures();

}  // namespace caustic
