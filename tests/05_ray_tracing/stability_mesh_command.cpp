#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <utility>

#include "core/process.h"
#include "image/image_file.h"
#include "math/color.h"
#include "support/paths.h"
#include "support/temporary_folder.h"

namespace caustic {
namespace {

constexpr const char* cube =
    "v -1 0 -1\nv 1 0 -1\nv 1 0 1\nv -1 0 1\nv -1 2 -1\nv 1 2 -1\nv 1 2 1\nv -1 2 1\n"
    "f 1 2 3 4\nf 8 7 6 5\nf 1 5 6 2\nf 2 6 7 3\nf 3 7 8 4\nf 4 8 5 1\n";

ProcessResult renderMesh(const std::string& file, const std::string& material, const std::filesystem::path& out) {
    return *runProcess(
        {test::chapterProgram(), "--mesh", file, "--material", material, "--threads", "1", "--out", out.string()});
}

TEST(MeshCommand, WritesAPictureForEachMaterial) {
    const test::TemporaryFolder folder;
    const auto file = folder.write("cube.obj", cube);
    for (const char* const material : {"glass", "diffuse", "mirror"}) {
        const ProcessResult result = renderMesh(file.string(), material, folder / material);
        EXPECT_EQ(result.exitCode, 0) << result.output;
        EXPECT_TRUE(std::filesystem::exists(folder / material / "05_ray_tracing" / "mesh.png"));
    }
}

// Its upper face mirrors the ceiling and what is behind the camera: there is something everywhere.
TEST(MeshCommand, AMirrorHasSomethingToReflect) {
    const test::TemporaryFolder folder;
    const auto file = folder.write("cube.obj", cube);
    ASSERT_EQ(renderMesh(file.string(), "mirror", folder / "out").exitCode, 0);
    const Image picture = loadImage(folder / "out" / "05_ray_tracing" / "mesh.png");
    int black = 0;
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) black += luminance(picture.at(x, y)) < 0.01 ? 1 : 0;
    }
    EXPECT_EQ(black, 0);
}

TEST(MeshCommand, BadInputIsOneLineAndWritesNothing) {
    const test::TemporaryFolder folder;
    const auto good = folder.write("cube.obj", cube);
    const auto empty = folder.write("empty.obj", "");
    const auto notANumber = folder.write("nan.obj", "v 0 0 nan\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const auto flat = folder.write("flat.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n");
    const auto beyond = folder.write("beyond.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n");
    const auto negative = folder.write("negative.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 -9\n");
    const auto cut = folder.write("cut.ply",
                                  "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                                  "property float z\nelement face 1\nproperty list uchar int vertex_indices\n"
                                  "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1");
    const auto unknown = folder.write("mesh.xyz", "1 2 3\n");
    const std::pair<std::string, std::string> bad[] = {
        {good.string(), "gold"},        {(folder / "missing.obj").string(), "glass"},
        {empty.string(), "glass"},      {notANumber.string(), "glass"},
        {flat.string(), "mirror"},      {beyond.string(), "diffuse"},
        {negative.string(), "diffuse"}, {cut.string(), "glass"},
        {unknown.string(), "glass"},    {folder.path().string(), "glass"}};
    for (const auto& [file, material] : bad) {
        const ProcessResult result = renderMesh(file, material, folder / "out");
        EXPECT_EQ(result.exitCode, 2) << file << " " << material << ": " << result.output;
        EXPECT_EQ(std::ranges::count(result.output, '\n'), 1) << result.output;
        EXPECT_FALSE(std::filesystem::exists(folder / "out"));
    }
    EXPECT_EQ(renderMesh("", "glass", folder / "out").exitCode, 2);
    const auto alone = runProcess({test::chapterProgram(), "--mesh"});
    EXPECT_EQ(alone->exitCode, 2);
}

// A file where the folder should be, and a place where nobody may make one.
TEST(MeshCommand, UnwritableFoldersAreNamed) {
    const test::TemporaryFolder folder;
    const auto file = folder.write("cube.obj", cube);
    const std::string inTheWay = folder.write("blocker", "a file").string();
    for (const std::string& out : {inTheWay, std::string("/proc/no_folder")}) {
        const ProcessResult result = renderMesh(file.string(), "diffuse", out);
        EXPECT_EQ(result.exitCode, 2) << result.output;
        EXPECT_NE(result.output.find(out), std::string::npos) << result.output;
    }
    EXPECT_TRUE(std::filesystem::is_regular_file(inTheWay));
}

// A chart needs gnuplot, a picture doesn't. Without it nothing of the chart is left but its numbers.
TEST(ChapterProgram, SaysWhenGnuplotIsMissing) {
    const test::TemporaryFolder folder;
    const auto run = [&](const char* figure) {
        return *runProcess({"/usr/bin/env", "PATH=/nowhere", test::chapterProgram(), "--only", figure, "--quality",
                            "draft", "--threads", "1", "--out", folder.path().string()});
    };
    const ProcessResult chart = run("failure");
    EXPECT_EQ(chart.exitCode, 2) << chart.output;
    EXPECT_NE(chart.output.find("gnuplot-nox"), std::string::npos) << chart.output;
    EXPECT_FALSE(std::filesystem::exists(folder / "05_ray_tracing" / "failure.png"));
    EXPECT_EQ(run("quantity").exitCode, 0);
}

}  // namespace
}  // namespace caustic
