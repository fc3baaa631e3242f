#pragma once

#include <vector>

#include "figure/failures.h"

namespace caustic {

/// What a grid or an update gets wrong that the chapter's own gets right.
std::vector<FailureKind> structureKinds();

/// What a start radius or an α gets wrong: each case is rendered.
std::vector<FailureKind> settingKinds();

}  // namespace caustic
