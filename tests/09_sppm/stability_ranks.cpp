#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/process.h"
#include "core/random.h"
#include "core/text.h"
#include "support/paths.h"
#include "support/temporary_folder.h"
#include "thumbnail.h"

namespace caustic {
namespace {

using Words = std::vector<std::string>;
using test::bytesOf;
using test::thumbnailPicture;

// What stands before the first rank. Open MPI asks for three of these where root runs more ranks than there are
// processors; others don't know them. The last two are for builds with sanitizers: what MPI's own plug-ins leave behind
// at the end is no leak of ours, and MPICH's transport hooks into the memory functions that a sanitizer hooks into as
// well.
const Words mpirun = {"env",
                      "OMPI_ALLOW_RUN_AS_ROOT=1",
                      "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1",
                      "OMPI_MCA_rmaps_base_oversubscribe=1",
                      "ASAN_OPTIONS=detect_leaks=0",
                      "UCX_MEM_EVENTS=no",
                      "timeout",
                      "60",
                      "mpirun"};

Words operator+(Words first, const Words& second) {
    first.insert(first.end(), second.begin(), second.end());
    return first;
}

// The program of the ranks lies beside the chapter's.
std::string ranksProgram() {
    return (std::filesystem::path(test::chapterProgram()).parent_path() / "sppm_ranks").string();
}

Words rendering(const std::filesystem::path& out, const Words& more) {
    return Words{"--render", "thumbnail", "--threads", "1", "--photons", "3000", "--out", out.string()} + more;
}

ProcessResult runAlone(const std::filesystem::path& out, const Words& more) {
    return *runProcess(Words{test::chapterProgram()} + rendering(out, more));
}

ProcessResult runRanks(int count, const Words& arguments) {
    return *runProcess(mpirun + Words{"-n", std::to_string(count), ranksProgram()} + arguments);
}

std::ptrdiff_t timesSaid(const std::string& words, const std::string& output) {
    std::ptrdiff_t count = 0;
    for (std::size_t at = output.find(words); at != std::string::npos; at = output.find(words, at + 1)) ++count;
    return count;
}

// The last number of passes before this word; 0 when there is none.
long long lastNumber(const std::string& before, const std::string& output) {
    const std::size_t at = output.rfind(before);
    if (at == std::string::npos) return 0;
    const std::size_t begin = at + before.size();
    return parseInteger(output.substr(begin, output.find(' ', begin) - begin)).value_or(0);
}

// Becomes the program behind it, which is killed some seconds after a file is there: its words are the file and the
// seconds.
const char* const killed = R"(
(until [ -e "$1" ]; do kill -0 $$ || exit; sleep 0.01; done; sleep "$2"; kill -KILL $$) 2> /dev/null &
exec "${@:3}"
)";

// A job in which one rank is killed.
ProcessResult runAndKill(int victim, int count, const Words& program, const std::string& file, double after) {
    Words job = mpirun;
    for (int rank = 0; rank < count; ++rank) {
        if (rank > 0) job.push_back(":");
        job = job + Words{"-n", "1"};
        if (rank == victim) job = job + Words{"bash", "-c", killed, "killed", file, formatReal(after)};
        job = job + program;
    }
    return *runProcess(job);
}

// Ten passes leave some of three and four ranks without one in the last round.
TEST(Ranks, SameBytesAsAlone) {
    const test::TemporaryFolder folder;
    const Words wanted = {"--passes", "10"};
    ASSERT_EQ(runAlone(folder / "alone", wanted).exitCode, 0);
    const std::string alone = bytesOf(folder / "alone" / thumbnailPicture);
    ASSERT_FALSE(alone.empty());
    for (const int count : {1, 2, 3, 4}) {
        const auto out = folder / std::to_string(count);
        const ProcessResult result = runRanks(count, rendering(out, wanted));
        ASSERT_EQ(result.exitCode, 0) << result.output;
        EXPECT_EQ(bytesOf(out / thumbnailPicture), alone) << count << " ranks";
    }
}

TEST(Ranks, EitherProgramGoesOnWithTheOthersCheckpoint) {
    const test::TemporaryFolder folder;
    ASSERT_EQ(runAlone(folder / "whole", {"--passes", "14"}).exitCode, 0);
    const std::string state = (folder / "state").string();
    const auto until = [&state](const char* passes) { return Words{"--passes", passes, "--checkpoint", state}; };
    ASSERT_EQ(runAlone(folder / "out", until("3")).exitCode, 0);
    ASSERT_EQ(runRanks(3, rendering(folder / "out", until("8"))).exitCode, 0);
    ASSERT_EQ(runAlone(folder / "out", until("11")).exitCode, 0);
    ASSERT_EQ(runRanks(2, rendering(folder / "out", until("14"))).exitCode, 0);
    EXPECT_EQ(bytesOf(folder / "out" / thumbnailPicture), bytesOf(folder / "whole" / thumbnailPicture));
}

// Each rank in turn, rank 0 as well, at a random time: some before there is a checkpoint.
TEST(Ranks, GoesOnAfterARankWasKilled) {
    const test::TemporaryFolder folder;
    const Words wanted = {"--passes", "160", "--every", "6"};
    ASSERT_EQ(runAlone(folder / "whole", wanted).exitCode, 0);
    const std::string whole = bytesOf(folder / "whole" / thumbnailPicture);
    Random random(3, {});
    constexpr int count = 3;
    int kills = 0;
    int told = 0;
    for (int trial = 0; trial < 2 * count; ++trial) {
        const std::string state = (folder / ("state" + std::to_string(trial))).string();
        const auto out = folder / ("out" + std::to_string(trial));
        const Words more = wanted + Words{"--checkpoint", state};
        const bool soon = trial >= count;
        const ProcessResult result = runAndKill(trial % count, count, Words{ranksProgram()} + rendering(out, more),
                                                soon ? "/" : state, random.uniform(0, soon ? 0.4 : 0.2));
        if (result.exitCode == 0) continue;  // it was done before
        ++kills;
        ASSERT_NE(result.exitCode, 124) << "mpirun was still waiting";
        if (const long long held = lastNumber(state + " holds ", result.output); held > 0) {
            ++told;
            const ProcessResult looked = runAlone(out, {"--passes", "1", "--checkpoint", state});
            EXPECT_EQ(looked.exitCode, 0) << looked.output;
            EXPECT_GE(lastNumber(".png: ", looked.output), held) << looked.output;
        }
        const ProcessResult again = runRanks(count, rendering(out, more));
        ASSERT_EQ(again.exitCode, 0) << again.output;
        ASSERT_EQ(bytesOf(out / thumbnailPicture), whole) << "rank " << trial % count << " of trial " << trial;
    }
    EXPECT_GT(kills, 0);
    EXPECT_GT(told, 0) << "Does it say what the checkpoint holds before a rank dies?";
}

// One rank that can't begin stops all, and it is the one that says why.
TEST(Ranks, BadInputIsSaidOnceAndStopsAll) {
    const test::TemporaryFolder folder;
    const std::string garbage = folder.write("garbage", "no checkpoint").string();
    const std::vector<Words> bad = {{"--passes", "3"},
                                    {"--render", "no_such_scene", "--passes", "1"},
                                    {"--render", "thumbnail"},
                                    {"--render", "thumbnail", "--passes", "1", "--alpha", "nan"},
                                    {"--render", "thumbnail", "--passes", "1", "--alpha", "1"},
                                    {"--render", "thumbnail", "--passes", "1", "--rule", "point"},
                                    {"--render", "thumbnail", "--passes", "1", "--checkpoint", garbage}};
    for (const Words& arguments : bad) {
        const ProcessResult result = runRanks(2, arguments + Words{"--out", (folder / "out").string()});
        EXPECT_EQ(result.exitCode, 2) << result.output;
        EXPECT_EQ(timesSaid("sppm_ranks: ", result.output), 1) << result.output;
        EXPECT_EQ(timesSaid("sppm_ranks: rank", result.output), 0) << result.output;
        EXPECT_FALSE(std::filesystem::exists(folder / "out"));
    }
    EXPECT_EQ(bytesOf(garbage), "no checkpoint");

    const Words good = Words{"-n", "1", ranksProgram()} + rendering(folder / "out", {"--passes", "2"});
    const ProcessResult result = *runProcess(mpirun + good + Words{":"} + good + Words{"--alpha", "1"});
    EXPECT_NE(result.exitCode, 0);
    EXPECT_EQ(timesSaid("sppm_ranks: rank 1: ", result.output), 1) << result.output;
    EXPECT_FALSE(std::filesystem::exists(folder / "out"));
}

// Rank 0 finds out in the midst that its checkpoint can't be written, while the others run their passes.
TEST(Ranks, AFailureOnTheWayEndsAll) {
    const test::TemporaryFolder folder;
    const std::string state = (folder.write("file", "") / "state").string();
    const ProcessResult result =
        runRanks(3, rendering(folder / "out", {"--passes", "1000000", "--every", "2", "--checkpoint", state}));
    EXPECT_NE(result.exitCode, 0);
    EXPECT_NE(result.exitCode, 124) << "mpirun was still waiting";
    EXPECT_EQ(timesSaid("sppm_ranks: ", result.output), 1) << result.output;
}

TEST(Ranks, HelpIsPrintedOnce) {
    const ProcessResult result = runRanks(2, {"--help"});
    EXPECT_EQ(result.exitCode, 0);
    EXPECT_EQ(timesSaid("--passes", result.output), 1) << result.output;
}

}  // namespace
}  // namespace caustic
