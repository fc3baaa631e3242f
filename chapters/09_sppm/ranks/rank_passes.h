#pragma once

#include <cstdint>

#include "ranks/ranks.h"
#include "scene_rendering.h"

namespace caustic {

/// Goes on with a rendering by rule Pass until it has as many passes as are wished, spread over the ranks. Each has to
/// call it. Passes are merged on rank 0 in their order, so the picture is the same, bit for bit, for any number of
/// ranks, and the one that render() makes alone.
/// @param scene      made alike on all ranks
/// @param threads    of each rank, at least 1
/// @param rendering  on rank 0 what has been done before, and then all; others leave it as it is
void renderOverRanks(SceneRendering& scene, const RenderWishes& wishes, int threads, const Ranks& ranks,
                     Rendering& rendering);

}  // namespace caustic
