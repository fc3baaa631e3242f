#pragma once

#include <cstdint>
#include <span>

#include "camera/film.h"
#include "integrator/integrator.h"

namespace caustic {

class Progress;

/// A picture and what it cost.
struct Rendering {
    Film film;
    RayCounts counts;
};

/// Runs one pass and adds what it brings.
void addPass(const Integrator& integrator, std::span<const PathId> paths, int threads, Rendering& rendering);

/// Renders every pixel with the same number of paths, some rows at a time, so that memory stays bounded.
/// @param samples   paths a pixel, at least 1
/// @param threads   at least 1; the picture doesn't depend on it
/// @param progress  told of each pixel; null for none
/// @throws InputError when samples is less than 1
Rendering render(const Integrator& integrator, std::int64_t samples, int threads, Progress* progress = nullptr);

}  // namespace caustic
