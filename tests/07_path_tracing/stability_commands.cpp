#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "core/process.h"
#include "support/paths.h"
#include "support/temporary_folder.h"

namespace caustic {
namespace {

ProcessResult run(std::vector<std::string> arguments, const std::filesystem::path& out) {
    arguments.insert(arguments.begin(), test::chapterProgram());
    for (const char* const more : {"--threads", "1", "--out"}) arguments.push_back(more);
    arguments.push_back(out.string());
    return *runProcess(arguments);
}

TEST(TimeCommand, WritesErrorsAndPicturesOfAllFive) {
    const test::TemporaryFolder folder;
    const ProcessResult result = run({"--time", "0.01", "--scene", "diffuse_box"}, folder / "out");
    EXPECT_EQ(result.exitCode, 0) << result.output;
    EXPECT_EQ(run({"--time=0.01", "--scene=diffuse_box"}, folder / "equals").exitCode, 0);
    int pictures = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder / "out/07_path_tracing"))
        pictures += entry.path().extension() == ".png" ? 1 : 0;
    EXPECT_EQ(pictures, 5);
    EXPECT_TRUE(std::filesystem::exists(folder / "out/07_path_tracing/timed_diffuse_box.csv"));
}

TEST(Commands, BadInputIsOneLineAndWritesNothing) {
    const std::vector<std::vector<std::string>> bad = {{"--time", "0"},
                                                       {"--time", "-1"},
                                                       {"--time", "nan"},
                                                       {"--time", "inf"},
                                                       {"--time", "ten"},
                                                       {"--time", "1", "--scene", "no_such_scene"},
                                                       {"--recalibrate", "0"},
                                                       {"--recalibrate", "1e400"},
                                                       {"--reference", "no_such_picture"},
                                                       {"--reference", "peers_box", "--minutes", "0"},
                                                       {"--trace", "5"},
                                                       {"--trace", "-1"},
                                                       {"--trace", "0", "--method", "5"},
                                                       {"--trace", "0", "--samples", "2000000"},
                                                       {"--scene", "peers_box"},
                                                       {"--trace", "0", "--scene", "peers_box"},
                                                       {"--time", "1", "--only", "methods"},
                                                       {"--time", "1", "--quality", "report"},
                                                       {"--time", "1", "--recalibrate", "1"}};
    for (const auto& arguments : bad) {
        const test::TemporaryFolder folder;
        const ProcessResult result = run(arguments, folder / "out");
        EXPECT_EQ(result.exitCode, 2) << arguments[0] << ' ' << arguments[1] << ": " << result.output;
        EXPECT_EQ(std::count(result.output.begin(), result.output.end(), '\n'), 1) << result.output;
        EXPECT_FALSE(std::filesystem::exists(folder / "out"));
    }
}

}  // namespace
}  // namespace caustic
