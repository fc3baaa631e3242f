#include <gtest/gtest.h>

#include <filesystem>

#include "core/process.h"
#include "support/temporary_folder.h"

namespace caustic {
namespace {

constexpr const char* cube =
    "v -1 0 -1\nv 1 0 -1\nv 1 0 1\nv -1 0 1\nv -1 2 -1\nv 1 2 -1\nv 1 2 1\nv -1 2 1\n"
    "f 1 2 3 4\nf 8 7 6 5\nf 1 5 6 2\nf 2 6 7 3\nf 3 7 8 4\nf 4 8 5 1\n";

ProcessResult renderMesh(const std::string& file, const std::string& material, const std::filesystem::path& out) {
    return *runProcess(
        {CAUSTIC_CHAPTER_PROGRAM, "--mesh", file, "--material", material, "--threads", "1", "--out", out.string()});
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

TEST(MeshCommand, BadInputIsOneLineAndWritesNothing) {
    const test::TemporaryFolder folder;
    const auto good = folder.write("cube.obj", cube);
    const auto empty = folder.write("empty.obj", "");
    const auto notANumber = folder.write("nan.obj", "v 0 0 nan\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const auto flat = folder.write("flat.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n");
    const auto beyond = folder.write("beyond.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n");
    const std::pair<std::string, std::string> bad[] = {
        {good.string(), "gold"},   {(folder / "missing.obj").string(), "glass"},
        {empty.string(), "glass"}, {notANumber.string(), "glass"},
        {flat.string(), "mirror"}, {beyond.string(), "diffuse"}};
    for (const auto& [file, material] : bad) {
        const ProcessResult result = renderMesh(file, material, folder / "out");
        EXPECT_EQ(result.exitCode, 2) << file << " " << material << ": " << result.output;
        EXPECT_FALSE(std::filesystem::exists(folder / "out" / "05_ray_tracing" / "mesh.png"));
    }
    const auto alone = runProcess({CAUSTIC_CHAPTER_PROGRAM, "--mesh"});
    EXPECT_EQ(alone->exitCode, 2);
}

}  // namespace
}  // namespace caustic
