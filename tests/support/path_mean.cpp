#include "support/path_mean.h"

#include <cmath>
#include <vector>

namespace caustic::test {

PathMean meanOfPaths(const Integrator& integrator, std::int64_t paths) {
    Real mean = 0;
    Real squares = 0;  // of the differences from the mean so far (Welford 1962)
    RayCounts counts;
    std::vector<Splat> splats;
    for (std::int64_t i = 0; i < paths; ++i) {
        splats.clear();
        Real value = integrator.tracePath({{0, 0}, i}, splats, counts).x();
        for (const Splat& one : splats) value += integrator.filter().density(one.film - Vec2(0.5, 0.5)) * one.value.x();
        const Real off = value - mean;
        mean += off / static_cast<Real>(i + 1);
        squares += off * (value - mean);
    }
    const Real n = static_cast<Real>(paths);
    return {mean, std::sqrt(squares / (n * (n - 1)))};
}

}  // namespace caustic::test
