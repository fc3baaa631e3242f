#include "support/path_mean.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace caustic::test {

namespace {

Real valueOf(const Integrator& integrator, std::int64_t index, std::vector<Splat>& splats) {
    RayCounts counts;
    splats.clear();
    Real value = integrator.tracePath({{0, 0}, index}, splats, counts).x();
    for (const Splat& one : splats) value += integrator.filter().density(one.film - Vec2(0.5, 0.5)) * one.value.x();
    return value;
}

PathMean rounds(const Integrator& integrator, int pathsPerRound, int first, int count) {
    Real mean = 0;
    Real squares = 0;  // of the differences from the mean so far (Welford 1962)
    std::vector<Splat> splats;
    for (int round = 0; round < count; ++round) {
        Real sum = 0;
        for (int i = 0; i < pathsPerRound; ++i)
            sum += valueOf(integrator, std::int64_t{first + round} * pathsPerRound + i, splats);
        const Real value = sum / pathsPerRound;
        const Real off = value - mean;
        mean += off / (round + 1);
        squares += off * (value - mean);
    }
    return {mean, std::sqrt(squares / (Real(count) * (count - 1)))};
}

}  // namespace

PathMean meanOfRounds(const Integrator& integrator, int pathsPerRound, Real wanted) {
    constexpr int trialRounds = 40;
    constexpr int leastRounds = 320;
    constexpr Real margin = 1.3;  // the trial's error is known to a tenth only
    const PathMean trial = rounds(integrator, pathsPerRound, 0, trialRounds);
    if (trial.standardError <= 1e-9 * trial.mean) return trial;  // no chance in it
    const Real times = margin * trial.standardError / wanted;
    const int needed = static_cast<int>(std::ceil(trialRounds * times * times));
    return rounds(integrator, pathsPerRound, trialRounds, std::max(leastRounds, needed));
}

}  // namespace caustic::test
