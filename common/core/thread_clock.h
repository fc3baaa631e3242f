#pragma once

#include <time.h>

namespace caustic {

/// Seconds that the calling thread has spent computing. What it waits, and what other threads do, isn't counted; so a
/// busy machine doesn't make a method look slow.
inline double threadSeconds() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}  // namespace caustic
