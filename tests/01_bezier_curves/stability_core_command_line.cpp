#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "core/process.h"
#include "support/paths.h"

namespace caustic {
namespace {

namespace fs = std::filesystem;

// Runs the real program, as a user would, in an empty folder.
class CommandLine : public testing::Test {
protected:
    void SetUp() override {
        const auto* test = testing::UnitTest::GetInstance()->current_test_info();
        folder_ =
            fs::path(testing::TempDir()) / ("caustic." + std::string(test->name()) + "." + std::to_string(getpid()));
        fs::create_directories(folder_);
    }
    void TearDown() override { fs::remove_all(folder_); }

    ProcessResult run(std::vector<std::string> arguments) const {
        std::vector<std::string> command = {"env", "-C", folder_.string(), test::chapterProgram()};
        command.insert(command.end(), arguments.begin(), arguments.end());
        return runProcess(command).value();
    }

    // Refused: exit code 2, one line that holds `part`, nothing written.
    void expectRefused(const std::vector<std::string>& arguments, const std::string& part) const {
        const ProcessResult result = run(arguments);
        EXPECT_EQ(result.exitCode, 2) << result.output;
        EXPECT_NE(result.output.find(part), std::string::npos) << result.output;
        EXPECT_EQ(std::count(result.output.begin(), result.output.end(), '\n'), 1) << result.output;
        EXPECT_TRUE(fs::is_empty(folder_)) << "something was written";
    }

    fs::path folder_;
};

TEST_F(CommandLine, HelpNamesEveryOptionAndEndsWell) {
    const ProcessResult result = run({"--help"});
    EXPECT_EQ(result.exitCode, 0);
    for (const char* option : {"--out", "--quality", "--threads", "--seed", "--only", "--list", "--preview"}) {
        EXPECT_NE(result.output.find(option), std::string::npos) << option;
    }
    EXPECT_TRUE(fs::is_empty(folder_));
}

TEST_F(CommandLine, ListNamesTheFiguresAndDrawsNone) {
    const ProcessResult result = run({"--list"});
    EXPECT_EQ(result.exitCode, 0);
    EXPECT_NE(result.output.find("speed_accuracy (timed)\n"), std::string::npos) << result.output;
    EXPECT_TRUE(fs::is_empty(folder_));
}

TEST_F(CommandLine, BadOptionsAreRefusedByName) {
    expectRefused({"--nonsense"}, "--nonsense");
    expectRefused({"stray"}, "stray");
    expectRefused({"--out"}, "--out");
    expectRefused({"--quality", "superb"}, "superb");
    expectRefused({"--threads", "0"}, "--threads");
    expectRefused({"--threads", "-1"}, "--threads");
    expectRefused({"--threads", "many"}, "many");
    expectRefused({"--seed", "-1"}, "--seed");
    expectRefused({"--seed", "1e3"}, "1e3");
}

// Wrong values name the right ones.
TEST_F(CommandLine, HelpAndRefusalsNameRangesAndDefaults) {
    const std::string help = run({"--help"}).output;
    for (const char* part :
         {"Q {draft, report}=draft", "N in [1, 1024]=", "S in [0, 9223372036854775807]=1", "DIR=figures"})
        EXPECT_NE(help.find(part), std::string::npos) << part << help;
    expectRefused({"--quality=superb"}, "must be one of draft, report (got 'superb')");
    expectRefused({"--threads=1025"}, "must be a whole number from 1 to 1024 (got '1025')");
}

TEST_F(CommandLine, OptionsThatWouldDoNothingAreRefused) {
    expectRefused({"--inspect", "profile.svg", "--seed", "2"}, "--seed: does nothing with --inspect");
    expectRefused({"--only", "bounds", "--inspect", "profile.svg"}, "--only: does nothing with --inspect");
    expectRefused({"--list", "--preview"}, "--preview: does nothing with --list");
}

TEST_F(CommandLine, UnknownFigureIsRefusedWithTheListOfThoseThatAre) {
    expectRefused({"--only", "no_such_figure"}, "no_such_figure");
    expectRefused({"--only", "no_such_figure"}, "speed_accuracy");
    expectRefused({"--only", ""}, "no such figure");
}

TEST_F(CommandLine, UnwritableOutIsRefusedByName) {
    std::ofstream(folder_ / "blocker") << "a file";
    const ProcessResult result = run({"--out", "blocker/figures", "--only", "de_casteljau"});
    EXPECT_EQ(result.exitCode, 2) << result.output;
    EXPECT_NE(result.output.find("blocker/figures"), std::string::npos) << result.output;
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 1);
}

}  // namespace
}  // namespace caustic
