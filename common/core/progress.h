#pragma once

#include <chrono>
#include <cstdint>
#include <mutex>
#include <string>

namespace caustic {

/// Progress of long work on standard error: a bar with the time left on a terminal, plain lines (at most one every five
/// seconds) elsewhere. May be advanced from any thread.
class Progress {
public:
    /// @param title  what is being done, as in "de_casteljau"
    explicit Progress(std::string title);
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    /// Ends the line, with the time that it took.
    ~Progress();

    /// Says how many steps it takes from now on; until then the title is shown without a share.
    void expect(std::int64_t total);

    /// Says that as many further steps are done.
    void advance(std::int64_t steps = 1);

private:
    using Clock = std::chrono::steady_clock;
    void show(Clock::time_point now);

    std::string title_;
    std::int64_t total_ = 0;
    std::int64_t done_ = 0;
    bool terminal_;
    Clock::time_point start_;
    Clock::time_point shown_;
    std::mutex mutex_;
};

/// Seconds as a person says them: "0.8 s", "42 s", "3 min 05 s", "2 h 10 min".
std::string formatDuration(double seconds);

}  // namespace caustic
