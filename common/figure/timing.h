#pragma once

#include <cstdint>
#include <functional>
#include <vector>

namespace caustic {

/// Tells the optimiser that `value` is used, so that the work which made it cannot be left out of what is timed.
template <typename Value>
void keep(const Value& value) {
    asm volatile("" : : "g"(&value) : "memory");
}

/// How long to measure.
struct TimingPlan {
    int rounds = 15;                ///< each piece of work is timed so many times; the median counts
    double secondsPerBatch = 2e-3;  ///< a piece is called until this has passed, so that the clock's grain is nothing
};

/// Nanoseconds per call of each piece of work, in this thread's own computing time: the median of `plan.rounds`
/// batches. A piece that starts threads or waits shows less than what a clock on the wall does.
///
/// The pieces take turns, a batch each round, so that a machine that slows down slows all of them. A piece must use
/// its result (keep()), and do the same at each call.
std::vector<double> medianNanoseconds(const std::vector<std::function<void()>>& pieces, const TimingPlan& plan);

}  // namespace caustic
