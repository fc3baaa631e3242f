#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "core/process.h"
#include "core/random.h"
#include "core/text.h"
#include "support/measured_process.h"
#include "support/paths.h"
#include "support/temporary_folder.h"
#include "thumbnail.h"

namespace caustic {
namespace {

std::vector<std::string> render(const std::filesystem::path& out, std::vector<std::string> more,
                                const std::string& photons = "3000") {
    std::vector<std::string> command = {
        test::chapterProgram(), "--render", "thumbnail", "--threads", "1", "--photons", photons, "--out", out.string()};
    command.insert(command.end(), more.begin(), more.end());
    return command;
}

using test::bytesOf;

const char* const picture = test::thumbnailPicture;

// Killed at a random time, again and again, and started anew each time: the bytes of one that never was.
TEST(RenderCommand, GoesOnAfterAKill) {
    const test::TemporaryFolder folder;
    for (const char* const rule : {"pass", "point"}) {
        const std::vector<std::string> wanted = {"--passes", "30", "--rule", rule};
        ASSERT_EQ(runProcess(render(folder / rule, wanted))->exitCode, 0);
        const std::string whole = bytesOf(folder / rule / picture);
        ASSERT_FALSE(whole.empty());
        Random random(7, {static_cast<std::uint64_t>(rule[1])});
        int kills = 0;
        for (int trial = 0; trial < 10; ++trial) {
            const auto state = folder / (std::string(rule) + std::to_string(trial));
            std::vector<std::string> stoppable = wanted;
            for (const std::string& one :
                 {std::string("--checkpoint"), state.string(), std::string("--every"), std::string("3")})
                stoppable.push_back(one);
            const auto out = folder / "resumed";
            std::filesystem::remove_all(out);
            std::vector<std::string> killed = render(out, stoppable);
            const std::string after = formatReal(random.uniform(0.02, 0.4));
            killed.insert(killed.begin(), {"timeout", "-s", "KILL", after});
            kills += runProcess(killed)->exitCode != 0 ? 1 : 0;
            const auto result = runProcess(render(out, stoppable));
            ASSERT_EQ(result->exitCode, 0) << result->output;
            ASSERT_EQ(bytesOf(out / picture), whole) << rule << ", killed after " << after << " s";
        }
        EXPECT_GT(kills, 0);
    }
}

// What the process holds at most, after 1,000 passes and after 10.
TEST(RenderCommand, MemoryDoesNotGrow) {
    const test::TemporaryFolder folder;
    for (const char* const rule : {"pass", "point"}) {
        const auto peak = [&](const char* passes) {
            // The address sanitizer keeps what is freed, unless it is told not to.
            std::vector<std::string> command = {"env", "ASAN_OPTIONS=quarantine_size_mb=0"};
            const auto rendered = render(folder / "out", {"--passes", passes, "--rule", rule}, "300");
            command.insert(command.end(), rendered.begin(), rendered.end());
            const test::MeasuredRun run = test::runMeasured(command, folder.path());
            EXPECT_EQ(run.exitCode, 0) << run.errors;
            return run.peakMiB;
        };
        const double few = peak("10");
        EXPECT_LE(peak("1000"), 1.02 * few + 0.5) << rule;
    }
}

TEST(RenderCommand, SameBytesForAnyThreads) {
    const test::TemporaryFolder folder;
    ASSERT_EQ(runProcess(render(folder / "one", {"--passes", "4"}))->exitCode, 0);
    std::vector<std::string> two = render(folder / "two", {"--passes", "4"});
    *std::find(two.begin(), two.end(), "1") = "2";
    ASSERT_EQ(runProcess(two)->exitCode, 0);
    EXPECT_EQ(bytesOf(folder / "one" / picture), bytesOf(folder / "two" / picture));
}

// Another scene, setting or seed than the checkpoint's: refused by its name, and left as it was.
TEST(RenderCommand, RefusesAnotherPicturesCheckpoint) {
    const test::TemporaryFolder folder;
    const std::string state = (folder / "glass.state").string();
    ASSERT_EQ(runProcess(render(folder / "out", {"--passes", "2", "--checkpoint", state}))->exitCode, 0);
    const std::string before = bytesOf(state);
    for (const std::vector<std::string>& other : std::vector<std::vector<std::string>>{
             {"--alpha", "0.5"}, {"--radius", "0.01"}, {"--rule", "point"}, {"--seed", "9"}}) {
        std::vector<std::string> more = {"--passes", "4", "--checkpoint", state};
        more.insert(more.end(), other.begin(), other.end());
        const auto result = runProcess(render(folder / "out", more));
        EXPECT_EQ(result->exitCode, 2) << other[0];
        EXPECT_NE(result->output.find("glass.state"), std::string::npos) << result->output;
        EXPECT_EQ(bytesOf(state), before);
    }
}

TEST(RenderCommand, BadInputIsOneLineAndWritesNothing) {
    const std::vector<std::vector<std::string>> bad = {{"--render", "no_such_scene", "--passes", "1"},
                                                       {"--render", "thumbnail"},
                                                       {"--render", "thumbnail", "--passes", "-1"},
                                                       {"--render", "thumbnail", "--passes", "1.5"},
                                                       {"--render", "thumbnail", "--time", "-1"},
                                                       {"--render", "thumbnail", "--passes", "1", "--alpha", "0"},
                                                       {"--render", "thumbnail", "--passes", "1", "--alpha", "1"},
                                                       {"--render", "thumbnail", "--passes", "1", "--alpha", "nan"},
                                                       {"--render", "thumbnail", "--passes", "1", "--radius", "-1"},
                                                       {"--render", "thumbnail", "--passes", "1", "--photons", "0"},
                                                       {"--render", "thumbnail", "--passes", "1", "--rule", "both"},
                                                       {"--render", "thumbnail", "--passes", "1", "--every", "0"},
                                                       {"--errors", "peers_box"},
                                                       {"--errors", "wine_glass", "--time", "1"},
                                                       {"--reference", "wine_glass"},
                                                       {"--reference", "peers_box", "--minutes", "0"}};
    for (const std::vector<std::string>& arguments : bad) {
        const test::TemporaryFolder folder;
        std::vector<std::string> command = arguments;
        command.insert(command.begin(), test::chapterProgram());
        if (arguments[0] != "--reference") command.insert(command.end(), {"--out", (folder / "out").string()});
        const auto result = runProcess(command);
        EXPECT_EQ(result->exitCode, 2) << arguments[0] << ' ' << arguments[1] << ' ' << result->output;
        EXPECT_EQ(std::count(result->output.begin(), result->output.end(), '\n'), 1) << result->output;
        EXPECT_FALSE(std::filesystem::exists(folder / "out"));
    }
}

}  // namespace
}  // namespace caustic
