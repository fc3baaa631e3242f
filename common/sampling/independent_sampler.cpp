#include "sampling/independent_sampler.h"

#include "sampling/path_stream.h"

namespace caustic {

Real IndependentSampler::number(const PathName& path, Dimension dimension) const {
    return PathStream(seed_, path, path.index).number(dimension);
}

Vec2 IndependentSampler::pair(const PathName& path, Dimension dimension) const {
    return PathStream(seed_, path, path.index).pair(dimension);
}

}  // namespace caustic
