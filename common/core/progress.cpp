#include "core/progress.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

namespace caustic {

namespace {

constexpr int barWidth = 24;

double secondsBetween(std::chrono::steady_clock::time_point from, std::chrono::steady_clock::time_point to) {
    return std::chrono::duration<double>(to - from).count();
}

}  // namespace

std::string formatDuration(double seconds) {
    char text[32];
    const auto whole = std::llround(seconds);
    if (seconds < 9.95) {
        std::snprintf(text, sizeof text, "%.1f s", seconds);
    } else if (whole < 60) {
        std::snprintf(text, sizeof text, "%lld s", whole);
    } else if (whole < 3600) {
        std::snprintf(text, sizeof text, "%lld min %02lld s", whole / 60, whole % 60);
    } else {
        std::snprintf(text, sizeof text, "%lld h %02lld min", whole / 3600, whole % 3600 / 60);
    }
    return text;
}

Progress::Progress(std::string title)
    : title_(std::move(title)), terminal_(isatty(STDERR_FILENO) == 1), start_(Clock::now()), shown_(start_) {
    if (terminal_) show(start_);
}

Progress::~Progress() {
    const std::string took = formatDuration(secondsBetween(start_, Clock::now()));
    std::fprintf(stderr, terminal_ ? "\r\x1b[K  %-28s %s\n" : "  %-28s %s\n", title_.c_str(), took.c_str());
}

void Progress::expect(std::int64_t total) {
    const std::scoped_lock lock(mutex_);
    total_ = total;
    done_ = 0;
}

void Progress::advance(std::int64_t steps) {
    const std::scoped_lock lock(mutex_);
    done_ += steps;
    const auto now = Clock::now();
    const double pause = terminal_ ? 0.1 : 5;
    if (secondsBetween(shown_, now) < pause) return;
    shown_ = now;
    show(now);
}

void Progress::show(Clock::time_point now) {
    if (total_ <= 0) {
        std::fprintf(stderr, terminal_ ? "\r\x1b[K  %s" : "  %s\n", title_.c_str());
        return;
    }
    const double share = std::clamp(static_cast<double>(done_) / static_cast<double>(total_), 0.0, 1.0);
    std::string left;
    if (share > 0) left = formatDuration(secondsBetween(start_, now) * (1 - share) / share) + " left";
    if (terminal_) {
        const int filled = static_cast<int>(share * barWidth);
        const std::string bar = std::string(static_cast<std::size_t>(filled), '#') +
                                std::string(static_cast<std::size_t>(barWidth - filled), '.');
        std::fprintf(stderr, "\r\x1b[K  %-28s [%s] %3.0f %%  %s", title_.c_str(), bar.c_str(), 100 * share,
                     left.c_str());
        std::fflush(stderr);
    } else {
        std::fprintf(stderr, "  %s: %.0f %%, %s\n", title_.c_str(), 100 * share, left.c_str());
    }
}

}  // namespace caustic
