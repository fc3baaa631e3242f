// mpirun -n N sppm_ranks --render SCENE --passes N: the passes of chapter 09's rule ①, spread over the ranks of an MPI
// job.

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "chapter_inputs.h"
#include "core/error.h"
#include "figure/add_option.h"
#include "ranks/rank_passes.h"
#include "ranks/ranks.h"

namespace caustic {
namespace {

constexpr int exitFailure = 1;
constexpr int exitBadInput = 2;

struct Options {
    std::string scene;
    RenderWishes wishes;
    std::string out = "figures";
    std::int64_t threads = 1;
    std::int64_t seed = 1;
};

void addOptions(CLI::App& app, Options& options) {
    constexpr std::int64_t mostThreads = 1024;
    addOption(app, {"--render", "SCENE", "What to render", ChoiceValue{&options.scene, sceneNames()}})->required();
    addOption(app,
              {"--passes", "N", "Passes in all", RangedValue<std::int64_t>{&options.wishes.passes, 1, 1'000'000'000}})
        ->required();
    std::vector<ChapterOption> optional = renderOptions(options.wishes);
    optional.insert(
        optional.end(),
        {{"--out", "DIR", "Folder to write to; a folder of the chapter's name is made in it", TextValue{&options.out}},
         {"--threads", "N", "Threads of each rank; the picture doesn't depend on it",
          RangedValue<std::int64_t>{&options.threads, 1, mostThreads}},
         {"--seed", "S", "Seed of all random numbers",
          RangedValue<std::int64_t>{&options.seed, 0, std::numeric_limits<std::int64_t>::max()}}});
    for (const ChapterOption& option : optional) addOption(app, option)->capture_default_str();
}

ChapterOptions chapterOptions(const Options& options) {
    ChapterOptions chapter;
    chapter.out = options.out;
    chapter.threads = static_cast<int>(options.threads);
    chapter.seed = static_cast<std::uint64_t>(options.seed);
    return chapter;
}

// Why a rank can't go on.
struct Failure {
    int exitCode;
    std::string reason;
};

std::optional<Failure> failureOf(const std::function<void()>& work) {
    try {
        work();
        return std::nullopt;
    } catch (const CLI::ParseError& error) {
        return Failure{exitBadInput, std::string(error.what()) + "; see --help"};
    } catch (const InputError& error) {
        return Failure{exitBadInput, error.what()};
    } catch (const std::exception& error) {
        return Failure{exitFailure, error.what()};
    }
}

void complain(const Failure& failure, const Ranks& ranks) {
    const std::string who = ranks.first() ? "" : "rank " + std::to_string(ranks.rank()) + ": ";
    std::fprintf(stderr, "sppm_ranks: %s%s\n", who.c_str(), failure.reason.c_str());
}

int run(int argc, const char* const* argv, const Ranks& ranks) {
    CLI::App app{"Renders a scene by SPPM, its passes spread over the ranks of an MPI job: mpirun -n N sppm_ranks ...",
                 "sppm_ranks"};
    Options options;
    std::unique_ptr<SceneRendering> scene;
    std::optional<Rendering> rendering;
    bool onlyHelp = false;
    const auto refused = failureOf([&] {
        addOptions(app, options);
        try {
            app.parse(argc, argv);
        } catch (const CLI::Success& request) {
            if (ranks.first()) app.exit(request);
            onlyHelp = true;
            return;
        }
        scene = std::make_unique<SceneRendering>(options.scene, options.wishes, thisChapter, chapterOptions(options));
        rendering = ranks.first() ? scene->begun() : scene->empty();
    });
    // Bad input is bad on all ranks; one of them says so.
    if (const auto outcome = ranks.failure(refused ? refused->exitCode : 0)) {
        if (outcome->rank == ranks.rank()) complain(*refused, ranks);
        return outcome->exitCode;
    }
    if (onlyHelp) return 0;
    const auto died = failureOf([&] {
        renderOverRanks(*scene, options.wishes, static_cast<int>(options.threads), ranks, *rendering);
        if (ranks.first()) scene->finish(*rendering);
    });
    if (!died) return 0;
    // The others are in the midst of a pass, or wait for this one.
    complain(*died, ranks);
    ranks.abort(died->exitCode);
}

}  // namespace
}  // namespace caustic

int main(int argc, char** argv) {
    const caustic::Ranks ranks;
    try {
        return caustic::run(argc, argv, ranks);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "sppm_ranks: %s\n", error.what());
        ranks.abort(caustic::exitFailure);
    }
}
