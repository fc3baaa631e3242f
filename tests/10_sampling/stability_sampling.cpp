#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "core/process.h"
#include "failures/failure_kinds.h"
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
