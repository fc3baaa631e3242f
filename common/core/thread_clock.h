#pragma once

#include <time.h>

#include <chrono>

namespace caustic {

/// Seconds that the calling thread has spent computing. What it waits, and what other threads do, isn't counted; so a
/// busy machine doesn't make a method look slow.
inline double threadSeconds() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Seconds of computing as a method's time is stated: of one thread what it has computed, of several what passes on the
/// wall. Only differences mean anything.
/// @param threads  that work, the calling one among them
inline double computingSeconds(int threads) {
    if (threads == 1) return threadSeconds();
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace caustic
