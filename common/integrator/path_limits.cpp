#include "integrator/path_limits.h"

#include "core/check.h"

namespace caustic {

const PathLimits& checkLimits(const PathLimits& limits) {
    checkArgument(limits.maxLength >= 1, "longest path", std::to_string(limits.maxLength),
                  "must be at least 1 segment");
    checkArgument(limits.rouletteStart >= 0, "roulette's first vertex", std::to_string(limits.rouletteStart),
                  "must be at least 0");
    return limits;
}

}  // namespace caustic
