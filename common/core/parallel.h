#pragma once

#include <atomic>
#include <cstdint>
#include <exception>
#include <limits>
#include <mutex>

#ifdef CAUSTIC_STD_THREADS
#include <thread>
#include <vector>
#endif

namespace caustic {

namespace detail {

// Keeps the exception of the lowest item, so that which error the user sees does not depend on the threads.
class FirstFailure {
public:
    bool happenedBefore(std::int64_t item) const { return item > lowest_.load(std::memory_order_relaxed); }

    void record(std::int64_t item, std::exception_ptr failure) {
        const std::scoped_lock lock(mutex_);
        if (item >= lowest_.load(std::memory_order_relaxed)) return;
        lowest_.store(item, std::memory_order_relaxed);
        failure_ = std::move(failure);
    }

    void rethrow() const {
        if (failure_) std::rethrow_exception(failure_);
    }

private:
    std::atomic<std::int64_t> lowest_{std::numeric_limits<std::int64_t>::max()};
    std::mutex mutex_;
    std::exception_ptr failure_;
};

}  // namespace detail

/// Calls body(i) once for each i in [0, count), on `threads` threads, in no particular order.
///
/// The result must not depend on that order: an item writes only what is its own. When bodies throw, items after the
/// lowest failed one may be left out and that item's exception is thrown here: a throw must not leave an OpenMP region.
template <typename Body>
void parallelFor(std::int64_t count, int threads, const Body& body) {
    detail::FirstFailure failure;
    const auto guarded = [&](std::int64_t i) {
        if (failure.happenedBefore(i)) return;
        try {
            body(i);
        } catch (...) {
            failure.record(i, std::current_exception());
        }
    };
#ifdef CAUSTIC_STD_THREADS
    // The thread sanitizer does not know GCC's OpenMP barriers and would report every loop as a race.
    std::atomic<std::int64_t> next{0};
    const auto work = [&] {
        for (std::int64_t i = next++; i < count; i = next++) guarded(i);
    };
    std::vector<std::jthread> others;
    for (int worker = 1; worker < threads; ++worker) others.emplace_back(work);
    work();  // as with OpenMP, the calling thread is one of them
    others.clear();
#else
#pragma omp parallel for schedule(dynamic) num_threads(threads)
    for (std::int64_t i = 0; i < count; ++i) guarded(i);
#endif
    failure.rethrow();
}

}  // namespace caustic
