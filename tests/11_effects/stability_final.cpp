#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>

#include "core/error.h"
#include "core/process.h"
#include "failures/map_failures.h"
#include "final_scene.h"
#include "maps.h"
#include "support/failure_checks.h"
#include "support/paths.h"
#include "support/temporary_folder.h"
#include "teapot.h"

namespace caustic {
namespace {

std::string bytesOf(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

const char* const picture = "11_effects/final.png";

std::vector<std::string> final(const std::filesystem::path& out, std::vector<std::string> more) {
    std::vector<std::string> command = {
        test::chapterProgram(), "--final", "32", "--photons", "1000", "--out", out.string()};
    command.insert(command.end(), more.begin(), more.end());
    return command;
}

TEST(MapFailures, OnlyFragileMethodsFail) {
    test::expectOnlyFragileMethodsFail(countFailures(mapKinds(), {.count = 1000, .seed = 77, .threads = 2}), 0.3);
}

// In two parts, with one thread and with two: the same bytes.
TEST(FinalCommand, GoesOnWhereItWasStopped) {
    const test::TemporaryFolder folder;
    const std::string state = (folder / "state").string();
    ASSERT_EQ(runProcess(final(folder / "whole", {"--passes", "3", "--threads", "2"}))->exitCode, 0);
    ASSERT_EQ(runProcess(final(folder / "parts", {"--passes", "1", "--threads", "1", "--checkpoint", state}))->exitCode,
              0);
    const std::string first = bytesOf(folder / "parts" / picture);
    ASSERT_EQ(runProcess(final(folder / "parts", {"--passes", "3", "--threads", "1", "--checkpoint", state}))->exitCode,
              0);
    EXPECT_EQ(bytesOf(folder / "parts" / picture), bytesOf(folder / "whole" / picture));
    EXPECT_NE(first, bytesOf(folder / "whole" / picture));
}

TEST(FinalCommand, RefusesWhatItCannotDo) {
    const test::TemporaryFolder folder;
    const auto refused = [&](std::vector<std::string> more, const char* names) {
        const auto result = runProcess(final(folder / "out", std::move(more)));
        ASSERT_TRUE(result);
        EXPECT_EQ(result->exitCode, 2) << result->output;
        EXPECT_NE(result->output.find(names), std::string::npos) << result->output;
        EXPECT_FALSE(std::filesystem::exists(folder / "out" / picture));
    };
    refused({"--passes", "0"}, "--passes");
    std::ofstream(folder / "bad") << "no checkpoint";
    refused({"--passes", "1", "--checkpoint", (folder / "bad").string()}, "bad");
}

TEST(FinalScene, NamesMissingAssets) {
    const test::TemporaryFolder folder;
    const auto nowhere = [&](const std::string& path) { return folder / path; };
    EXPECT_THROW(finalScene({}, nowhere, 16, 10), InputError);
    EXPECT_THROW(loadPanorama(folder / "none.exr"), InputError);
    for (const char* const text :
         {"", "# nothing\n", "pitch a 3 3\n", "patch a 3 3\n1 2 3\n", "patch a 0 3\n", "patch a x 3\n"}) {
        std::ofstream(folder / "pot.txt") << text;
        EXPECT_THROW(loadTeapot(folder / "pot.txt"), InputError) << text;
    }
}

// A panorama that is no image, or half of one, is refused by name.
TEST(Panoramas, DamagedFilesAreRefused) {
    const test::TemporaryFolder folder;
    const std::string whole = bytesOf(test::sourceDir() / "assets/environments/esplanade.exr");
    ASSERT_GT(whole.size(), 1000U);
    for (const std::size_t length : {std::size_t{0}, std::size_t{3}, std::size_t{200}, whole.size() / 2}) {
        std::ofstream(folder / "half.exr", std::ios::binary) << whole.substr(0, length);
        try {
            loadPanorama(folder / "half.exr");
            FAIL() << length << " bytes were taken for a panorama";
        } catch (const InputError& error) {
            EXPECT_NE(std::string(error.what()).find("half.exr"), std::string::npos) << error.what();
        }
    }
}

}  // namespace
}  // namespace caustic
