#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "core/process.h"
#include "failures/failure_kinds.h"
#include "image/image_file.h"
#include "support/failure_checks.h"
#include "support/paths.h"
#include "support/temporary_folder.h"

namespace caustic {
namespace {

TEST(SamplingFailures, OnlyFragileMethodsFail) {
    test::expectOnlyFragileMethodsFail(countFailures(samplingFailures(), {1000, 4711, 2}), 0.05);
}

TEST(RenderCommand, RendersByEachRuleAndSampler) {
    const test::TemporaryFolder folder;
    for (const std::vector<std::string>& more :
         std::vector<std::vector<std::string>>{{"--rule", "uniform", "--sampler", "halton"},
                                               {"--rule", "hash", "--sampler", "random"},
                                               {"--rule", "edges", "--sampler", "stratified"},
                                               {"--rule", "interval", "--tolerance", "0.1"},
                                               {"--rule", "gain"}}) {
        std::vector<std::string> command = {
            test::chapterProgram(),   "--render", "box", "--width", "12", "--paths", "20", "--out",
            (folder / "out").string()};
        command.insert(command.end(), more.begin(), more.end());
        const auto result = runProcess(command);
        EXPECT_EQ(result->exitCode, 0) << result->output;
        EXPECT_TRUE(std::filesystem::exists(folder / "out/10_sampling/render_box.png"));
    }
    EXPECT_TRUE(std::filesystem::exists(folder / "out/10_sampling/render_box_paths.png"));
}

// What a checkpoint holds is gone on with: a uniform picture comes out as if nobody had stopped, by one thread or two,
// and adaptive ones go on to the paths that are asked for. A checkpoint of another picture is refused, and stays.
TEST(RenderCommand, GoesOnFromACheckpoint) {
    const test::TemporaryFolder folder;
    const auto rendered = [&](const std::string& out, const std::vector<std::string>& more) {
        std::vector<std::string> command = {test::chapterProgram(), "--render", "box", "--width", "12", "--out",
                                            (folder / out).string()};
        command.insert(command.end(), more.begin(), more.end());
        return *runProcess(command);
    };
    const auto picture = [&](const std::string& out) {
        return loadImage(folder / (out + "/10_sampling/render_box.png"));
    };
    const std::string state = (folder / "state").string();
    const std::vector<std::string> uniform = {"--rule", "uniform", "--sampler", "halton"};
    const auto with = [](std::vector<std::string> words, const std::vector<std::string>& more) {
        words.insert(words.end(), more.begin(), more.end());
        return words;
    };
    ASSERT_EQ(rendered("whole", with(uniform, {"--paths", "24"})).exitCode, 0);
    ASSERT_EQ(rendered("half", with(uniform, {"--paths", "10", "--checkpoint", state, "--threads", "1"})).exitCode, 0);
    ASSERT_EQ(rendered("both", with(uniform, {"--paths", "24", "--checkpoint", state, "--threads", "2"})).exitCode, 0);
    const auto unlike = [&](const std::string& one, const std::string& other) {
        const Image first = picture(one);
        const Image second = picture(other);
        int count = 0;
        for (int y = 0; y < first.height(); ++y) {
            for (int x = 0; x < first.width(); ++x) count += (first.at(x, y) == second.at(x, y)).all() ? 0 : 1;
        }
        return count;
    };
    EXPECT_EQ(unlike("whole", "both"), 0) << "Does it go on with the next path?";
    EXPECT_GT(unlike("whole", "half"), 12) << "More paths must change the picture, or nothing is compared.";

    const ProcessResult other = rendered("other", {"--rule", "gain", "--paths", "24", "--checkpoint", state});
    EXPECT_NE(other.exitCode, 0) << "The checkpoint is of another picture.";
    EXPECT_FALSE(std::filesystem::exists(folder / "other/10_sampling/render_box.png"));
    ASSERT_EQ(rendered("again", with(uniform, {"--paths", "24", "--checkpoint", state})).exitCode, 0);

    const std::string adaptive = (folder / "adaptive").string();
    for (const char* const paths : {"20", "40"}) {
        const ProcessResult result =
            rendered(paths, {"--rule", "interval", "--tolerance", "1e-6", "--paths", paths, "--checkpoint", adaptive});
        ASSERT_EQ(result.exitCode, 0) << result.output;
    }
    EXPECT_GT(unlike("20", "40"), 12) << "Are there paths of the second call?";
}

TEST(RenderCommand, BadInputIsOneLineAndWritesNothing) {
    const std::vector<std::vector<std::string>> bad = {{"--render", "teapot"},
                                                       {"--render", "box", "--paths", "0"},
                                                       {"--render", "box", "--paths", "1.5"},
                                                       {"--render", "box", "--width", "0"},
                                                       {"--render", "box", "--width", "100000"},
                                                       {"--render", "box", "--tolerance", "0"},
                                                       {"--render", "box", "--tolerance", "nan"},
                                                       {"--render", "box", "--sampler", "latin"},
                                                       {"--render", "box", "--rule", "all"}};
    for (const std::vector<std::string>& arguments : bad) {
        const test::TemporaryFolder folder;
        std::vector<std::string> command = arguments;
        command.insert(command.begin(), test::chapterProgram());
        command.insert(command.end(), {"--out", (folder / "out").string()});
        const auto result = runProcess(command);
        EXPECT_EQ(result->exitCode, 2) << arguments.back() << ' ' << result->output;
        EXPECT_EQ(std::count(result->output.begin(), result->output.end(), '\n'), 1) << result->output;
        EXPECT_FALSE(std::filesystem::exists(folder / "out"));
    }
}

}  // namespace
}  // namespace caustic
