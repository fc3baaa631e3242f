#include "figure/timing.h"

#include <time.h>

#include <algorithm>

namespace caustic {

namespace {

// Seconds that this thread has spent computing. Measured with the machine four times overbooked, medians of wall time
// were off by up to a factor of ten: every other batch was interrupted.
double threadSeconds() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

double secondsOf(const std::function<void()>& piece, std::int64_t calls) {
    const double start = threadSeconds();
    for (std::int64_t i = 0; i < calls; ++i) piece();
    return threadSeconds() - start;
}

// Doubles the calls until a batch is long enough; this warms the caches up as well.
std::int64_t callsPerBatch(const std::function<void()>& piece, double seconds) {
    std::int64_t calls = 1;
    while (secondsOf(piece, calls) < seconds) calls *= 2;
    return calls;
}

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

}  // namespace

std::vector<double> medianNanoseconds(const std::vector<std::function<void()>>& pieces, const TimingPlan& plan) {
    std::vector<std::int64_t> calls;
    for (const auto& piece : pieces) calls.push_back(callsPerBatch(piece, plan.secondsPerBatch));

    std::vector<std::vector<double>> nanoseconds(pieces.size());
    for (int round = 0; round < plan.rounds; ++round) {
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            nanoseconds[i].push_back(secondsOf(pieces[i], calls[i]) / static_cast<double>(calls[i]) * 1e9);
        }
    }
    std::vector<double> medians;
    for (auto& batches : nanoseconds) medians.push_back(median(std::move(batches)));
    return medians;
}

}  // namespace caustic
