#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "figure/figure.h"
#include "methods.h"

namespace caustic {

/// How much work each method does in the same time, for pictures that are to be the same from run to run: work.json
/// beside this file, which --recalibrate measures anew.
class WorkCounts {
public:
    /// Reads the chapter's file.
    /// @throws InputError when it is missing or isn't such a file
    explicit WorkCounts(const std::filesystem::path& sources);

    /// Paths a pixel in the report; a draft does a sixteenth, but at least one.
    /// @param picture  "methods" or "caustic"
    std::int64_t samples(const std::string& picture, Method method, Quality quality) const;

    /// Seconds of one thread that the counts stand for.
    double seconds() const { return seconds_; }

private:
    double seconds_ = 0;
    std::map<std::string, std::map<std::string, std::int64_t>> samples_;
};

/// Renders each equal-time picture by each method for so many seconds of one thread, and writes work.json.
/// @param seconds  greater than 0
void recalibrate(double seconds, const ChapterInputs& chapter);

}  // namespace caustic
