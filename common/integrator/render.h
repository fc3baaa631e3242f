#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

#include "integrator/integrator.h"

namespace caustic {

class Progress;

/// How far a rendering goes and what happens on the way. It ends at the first of its limits; it needs one.
struct RenderSettings {
    /// Passes in all; of the usual ones that is paths a pixel. At least 1.
    std::int64_t passes = std::numeric_limits<std::int64_t>::max();

    /// Computing time in all, greater than 0: a pass that would probably end too late isn't begun, but one is done in
    /// any case. One thread's time is what it has computed, whatever else the machine does; of several threads it is
    /// the time that passes on the wall.
    double seconds = std::numeric_limits<double>::infinity();

    /// At least 1; the picture doesn't depend on it.
    int threads = 1;

    /// Shown the rendering after each pass, and says whether to go on. Its own time doesn't count. May be empty.
    std::function<bool(const Rendering& soFar)> look = {};

    /// Chooses the paths of the next pass, none for the end; when empty, each pass has one path of each pixel, whose
    /// index is the pass's number. The same rendering must give the same paths.
    std::function<std::vector<PathId>(const Rendering& soFar)> choose = {};

    /// Advanced by `progressSteps` in all; null for none.
    Progress* progress = nullptr;
};

/// How far a rendering advances its progress.
inline constexpr std::int64_t progressSteps = 1000;

/// Renders, pass by pass.
/// @throws InputError when a setting is out of its range, or nothing says when to end
Rendering render(Integrator& integrator, const RenderSettings& settings);

/// Goes on with a rendering that was stopped, or was read from a file together with what the integrator keeps. The
/// picture is the same, bit for bit, as without the stop. Limits are in all, what was done before included.
/// @throws InputError as render does
void resume(Integrator& integrator, const RenderSettings& settings, Rendering& rendering);

/// One path of each pixel, row by row from the top: what a pass usually does.
/// @param index  of each
std::vector<PathId> pathsOfAllPixels(const Camera& camera, std::int64_t index);

/// The picture of a rendering: the film's, with what the integrator adds to it.
Image developed(const Integrator& integrator, const Rendering& rendering);

/// Complains when a sample was no finite number.
/// @throws std::runtime_error that says how many, and where the first one was
void requireFinite(const Rendering& rendering);

}  // namespace caustic
