#pragma once

#include <cstdint>
#include <functional>

#include "integrator/render.h"

namespace caustic {

/// How far a rendering has come.
struct TimedMoment {
    std::int64_t samples = 0;  ///< paths of each pixel so far
    double seconds = 0;        ///< that they took
};

/// Renders in passes of one path a pixel, in one thread, as long as the thread's computing time allows: a pass that
/// would probably end too late isn't begun. At least one is done. After n passes the picture is that of render with n
/// samples, up to rounding.
/// @param seconds  of this thread's computing time, greater than 0
/// @param look     shown the picture after each pass, and says whether to go on; its own time doesn't count. May be
///                 empty.
/// @throws InputError when seconds isn't greater than 0
Rendering renderFor(const Integrator& integrator, double seconds,
                    const std::function<bool(const Rendering&, const TimedMoment&)>& look);

}  // namespace caustic
