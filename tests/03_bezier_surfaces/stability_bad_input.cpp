#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <string>

#include "core/error.h"
#include "patch_file.h"
#include "support/measured_process.h"
#include "support/paths.h"
#include "support/temporary_folder.h"
#include "surface/newton_revolution.h"
#include "surface/patch_surface.h"
#include "surface/surface_of_revolution.h"
#include "surface/tessellation.h"

namespace caustic {
namespace {

constexpr Real infinity = std::numeric_limits<Real>::infinity();
constexpr Real nan = std::numeric_limits<Real>::quiet_NaN();

BezierCurve curveOf(std::vector<Vec3> points) { return BezierCurve(std::move(points)); }

TEST(BadInput, ProfilesWithoutASurfaceAreRefused) {
    EXPECT_THROW(SurfaceOfRevolution(std::vector<BezierCurve>()), InputError);
    EXPECT_THROW(SurfaceOfRevolution({curveOf({Vec3(0, 0, 0), Vec3(0, 1, 0)})}), InputError) << "all on the axis";
    EXPECT_THROW(SurfaceOfRevolution({curveOf({Vec3(1, 0, 0), Vec3(1, 0, 0)})}), InputError) << "a mere circle";
    EXPECT_THROW(SurfaceOfRevolution({curveOf({Vec3(1, 0, 0)})}), InputError) << "degree 0";
    EXPECT_THROW(SurfaceOfRevolution({curveOf(std::vector<Vec3>(18, Vec3(1, 2, 0)))}), InputError) << "degree 17";
}

TEST(BadInput, PatchesMustHaveTheirNumberOfFinitePoints) {
    EXPECT_THROW(BezierPatch(3, 3, std::vector<Vec3>(15, Vec3::Zero())), InputError);
    EXPECT_THROW(BezierPatch(0, 3, std::vector<Vec3>(4, Vec3::Zero())), InputError);
    for (const Real bad : {nan, infinity, -infinity}) {
        EXPECT_THROW(BezierPatch(1, 1, {Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), Vec3(1, bad, 0)}), InputError);
    }
    EXPECT_THROW(PatchSurface(BezierPatch(1, 1, std::vector<Vec3>(4, Vec3::Ones()))), InputError) << "no area";
    EXPECT_THROW(PatchSurface(BezierPatch(10, 1, std::vector<Vec3>(22, Vec3::Ones()))), InputError) << "degree 10";
}

TEST(BadInput, TolerancesAndSamplesAreChecked) {
    const std::vector<BezierCurve> profile = {curveOf({Vec3(1, 0, 0), Vec3(1, 1, 0)})};
    const SurfaceOfRevolution tube(profile);
    for (const Real bad : {0.0, -1.0, nan, 1e-30}) EXPECT_THROW(tessellated(tube, bad), InputError) << bad;
    for (const int bad : {0, -1, 33}) {
        EXPECT_THROW(NewtonRevolution(profile, NewtonStartRule::Bracketing, bad), InputError) << bad;
    }
}

TEST(BadInput, RaysThatAreNotFiniteHitNothing) {
    const SurfaceOfRevolution surface({curveOf({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0)})});
    const PatchSurface patch(BezierPatch(1, 1, {Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), Vec3(1, 1, 1)}));
    for (int axis = 0; axis < 3; ++axis) {
        const Vec3 bad = nan * Vec3::Unit(axis).cwiseMax(0.1);
        EXPECT_FALSE(surface.intersect({bad, Vec3::UnitX()}));
        EXPECT_FALSE(surface.intersect({Vec3::Zero(), bad}));
        EXPECT_FALSE(patch.intersect({bad, Vec3::UnitX()}));
        EXPECT_FALSE(patch.intersect({Vec3::Zero(), bad}));
    }
}

// What the error says: file, line, value, reason.
TEST(BadInput, PatchFilesAreReadOrSaidWhy) {
    const std::string good = "patch a 1 1\n0 0 0 1 0 0\n0 1 0 1 1 0\n";
    EXPECT_EQ(parsePatches("# nothing\n\n" + good + good, "file").size(), 2U);
    const auto lineOf = [](const std::string& text) -> std::size_t {
        try {
            parsePatches(text, "file");
        } catch (const InputError& error) {
            EXPECT_EQ(error.place().file, "file");
            EXPECT_FALSE(error.reason().empty());
            return error.place().line;
        }
        ADD_FAILURE() << text;
        return 0;
    };
    EXPECT_EQ(lineOf("patch a 1\n"), 1U);
    EXPECT_EQ(lineOf("patch a 1 0\n"), 1U);
    EXPECT_EQ(lineOf("patch a 1 99\n"), 1U);
    EXPECT_EQ(lineOf("surface a 1 1\n"), 1U);
    EXPECT_EQ(lineOf("patch a 1 1\n0 0 0 1 0 0\n0 1 0 1 1\n"), 3U);
    EXPECT_EQ(lineOf("patch a 1 1\n0 0 0 1 0 0\n0 1 x 1 1 0\n"), 3U);
    EXPECT_EQ(lineOf("patch a 1 1\n0 0 0 1 0 nan\n0 1 0 1 1 0\n"), 2U);
    EXPECT_EQ(lineOf("patch a 1 1\n0 0 0 1 0 0\n"), 2U) << "truncated";
    EXPECT_THROW(parsePatches("", "file"), InputError);
    EXPECT_THROW(loadPatches("no such file"), InputError);
}

// The real program, run as a user would.
TEST(Profile, IsTurnedAndDrawnOrRefusedInOneLine) {
    const test::TemporaryFolder folder;
    const auto run = [&](const std::string& option, const std::string& value) {
        return test::runMeasured(
            {test::chapterProgram(), option, value, "--out", (folder / "out").string(), "--threads", "1"},
            folder.path());
    };
    const std::string vase = (test::sourceDir() / "assets/profiles/vase.svg").string();
    const test::MeasuredRun good = run("--profile", vase);
    EXPECT_EQ(good.exitCode, 0) << good.errors;
    EXPECT_TRUE(std::filesystem::exists(folder / "out/03_bezier_surfaces/revolved.png"));
    std::filesystem::remove_all(folder / "out");

    const auto expectRefused = [&](const std::string& option, const std::string& value) {
        const test::MeasuredRun bad = run(option, value);
        EXPECT_EQ(bad.exitCode, 2) << value << ": " << bad.errors;
        EXPECT_EQ(std::count(bad.errors.begin(), bad.errors.end(), '\n'), 1) << bad.errors;
        EXPECT_FALSE(std::filesystem::exists(folder / "out")) << value << ": something was written";
    };
    expectRefused("--profile", "missing.svg");
    expectRefused("--profile", folder.write("empty.svg", ""));
    expectRefused("--profile", folder.write("axis.txt", "0 0\n0 1\n0 2\n0 3\n"));
    expectRefused("--roots", "many");
    expectRefused("--roots", "1");
}

}  // namespace
}  // namespace caustic
