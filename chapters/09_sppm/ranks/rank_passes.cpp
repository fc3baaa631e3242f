#include "ranks/rank_passes.h"

#include <algorithm>
#include <cstdio>
#include <optional>
#include <sstream>

#include "core/progress.h"
#include "core/thread_clock.h"

namespace caustic {

namespace {

// Passes that are run at the same time: one of each rank, or fewer at the end.
struct Round {
    std::int64_t first;
    std::int64_t passes;

    // The pass of a rank. Rank 0 has the last one, so that its integrator is afterwards as if it had run them all.
    std::optional<std::int64_t> passOf(int rank) const {
        if (rank == 0) return first + passes - 1;
        if (rank < passes) return first + rank - 1;
        return std::nullopt;
    }
};

Rendering runPass(SceneRendering& scene, std::int64_t number, int threads) {
    const std::vector<PathId> paths = scene.pathsOf(number);
    const double start = computingSeconds(threads);
    Rendering pass = scene.sppm().runPass({number, paths}, threads);
    pass.seconds = computingSeconds(threads) - start;
    return pass;
}

std::string bytesOf(const Rendering& pass, const std::string& picture) {
    std::ostringstream out;
    ByteWriter to(out);
    pass.save(to, picture);
    return std::move(out).str();
}

Rendering passFrom(int rank, const Ranks& ranks, const SceneRendering& scene) {
    std::istringstream in(ranks.receive(rank));
    ByteReader from(in, "pass of rank " + std::to_string(rank));
    Rendering pass = scene.empty();
    pass.load(from, scene.picture());
    return pass;
}

// Rank 0's part of a round.
void gather(const Round& round, SceneRendering& scene, int threads, const Ranks& ranks, Rendering& rendering) {
    const Rendering last = runPass(scene, *round.passOf(0), threads);
    for (int rank = 1; rank < ranks.count() && round.passOf(rank); ++rank)
        rendering.merge(passFrom(rank, ranks, scene));
    rendering.merge(last);
}

}  // namespace

void renderOverRanks(SceneRendering& scene, const RenderWishes& wishes, int threads, const Ranks& ranks,
                     Rendering& rendering) {
    std::int64_t done = ranks.shared(rendering.passes);
    std::optional<Progress> progress;
    if (ranks.first()) {
        progress.emplace(std::to_string(ranks.count()) + (ranks.count() == 1 ? " rank" : " ranks"));
        progress->expect(wishes.passes - done);
    }
    if (done < wishes.passes) scene.useEdges(ranks.anyOf(scene.edgesOf(ranks.rank(), ranks.count())));
    while (done < wishes.passes) {
        const Round round = {done, std::min<std::int64_t>(ranks.count(), wishes.passes - done)};
        done += round.passes;
        if (!ranks.first()) {
            const auto own = round.passOf(ranks.rank());
            if (own) ranks.send(bytesOf(runPass(scene, *own, threads), scene.picture()));
            continue;
        }
        gather(round, scene, threads, ranks, rendering);
        progress->advance(round.passes);
        const bool due = done / wishes.every != round.first / wishes.every;
        // When a rank dies, nobody is left to say how far the rendering had come; so it is said now.
        if (due && scene.saveState(rendering))
            std::fprintf(stderr, "%s holds %lld passes\n", wishes.checkpoint.c_str(), static_cast<long long>(done));
    }
}

}  // namespace caustic
