#include "sampling/independent_sampler.h"

#include "core/random.h"
#include "sampling/path_stream.h"

namespace caustic {

Real IndependentSampler::number(const PathName& path, Dimension dimension) const {
    return pathStream(seed_, path, dimension, path.index).uniform();
}

Vec2 IndependentSampler::pair(const PathName& path, Dimension dimension) const {
    Random random = pathStream(seed_, path, dimension, path.index);
    const Real first = random.uniform();
    return {first, random.uniform()};
}

}  // namespace caustic
