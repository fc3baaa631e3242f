#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>

#include "camera/box_filter.h"
#include "camera/pinhole_camera.h"
#include "core/error.h"
#include "integrator/checkpoint.h"
#include "integrator/render.h"
#include "integrator/sppm.h"
#include "light/constant_environment.h"
#include "light/point_light.h"
#include "modeler/caustic_scene.h"
#include "modeler/objects.h"
#include "modeler/peers_box.h"
#include "sampling/sobol_sampler.h"
#include "support/temporary_folder.h"

namespace caustic {
namespace {

const SobolSampler sampler(3);
const BoxFilter filter;

SppmSettings settings(RadiusRule rule = RadiusRule::Pass, int photons = 2000) {
    SppmSettings settings;
    settings.rule = rule;
    settings.photons = photons;
    return settings;
}

Image pictureOf(Sppm& sppm, std::int64_t passes, int threads = 1) {
    const Rendering rendering = render(sppm, {.passes = passes, .threads = threads});
    EXPECT_EQ(rendering.film.badSamples(), 0);
    return developed(sppm, rendering);
}

bool sameBits(const Image& a, const Image& b) { return std::ranges::equal(a.data(), b.data()); }

Real brightest(const Image& picture) {
    Real most = 0;
    for (const float value : picture.data()) most = std::max(most, Real(value));
    return most;
}

TEST(Sppm, RefusesWhatIsOutOfRange) {
    const Scene scene(peersBox(4, 4));
    constexpr Real nan = std::numeric_limits<Real>::quiet_NaN();
    const auto refused = [&](const SppmSettings& bad) { EXPECT_THROW(Sppm(scene, sampler, filter, bad), InputError); };
    for (const Real alpha : {0.0, 1.0, -0.5, 1.5, nan}) {
        SppmSettings bad = settings();
        bad.alpha = alpha;
        refused(bad);
    }
    for (const Real radius : {-1.0, nan, std::numeric_limits<Real>::infinity()}) {
        SppmSettings bad = settings();
        bad.radius = radius;
        refused(bad);
    }
    refused(settings(RadiusRule::Pass, 0));
    refused(settings(RadiusRule::Point, -5));
    SppmSettings bad = settings();
    bad.limits.maxLength = 0;
    refused(bad);
}

// Nothing that shines, a lamp of no power, nothing that spreads light, no room for photons: a black picture, or what
// the eye sees straight; a sentence that says why; and no photon is traced.
TEST(Sppm, NoPhotonsWhereTheyWouldLightNothing) {
    const auto camera = std::make_shared<PinholeCamera>(Vec3(0, 1, 3), Vec3::Zero(), Vec3::UnitY(), 0.5, 6, 6);
    const SceneObject floor = diffuseRectangle({-1, 0, -1}, {0, 0, 2}, {2, 0, 0}, Color::Constant(0.7));
    const auto lamp = [](Real power) { return std::make_shared<PointLight>(Vec3(0, 1, 0), Color::Constant(power)); };
    const std::vector<SceneDescription> dark = {{{floor}, {}, Color::Zero(), camera},
                                                {{floor}, {lamp(0)}, Color::Zero(), camera},
                                                {{}, {lamp(5)}, Color::Zero(), camera},
                                                {{mirrorBall({0, 0, 0}, 0.5)}, {lamp(5)}, Color::Zero(), camera}};
    for (const SceneDescription& description : dark) {
        for (const RadiusRule rule : {RadiusRule::Pass, RadiusRule::Point}) {
            const Scene scene(description);
            Sppm sppm(scene, sampler, filter, settings(rule));
            EXPECT_FALSE(sppm.whyNoPhotons().empty());
            EXPECT_EQ(brightest(pictureOf(sppm, 3)), 0);
            EXPECT_EQ(sppm.storedPhotons(), 0U);
        }
    }
    const Scene lit({{floor}, {lamp(5)}, Color::Zero(), camera});
    SppmSettings shortPaths = settings();
    shortPaths.limits.maxLength = 2;
    Sppm direct(lit, sampler, filter, shortPaths);
    EXPECT_FALSE(direct.whyNoPhotons().empty());
    EXPECT_GT(brightest(pictureOf(direct, 2)), 0);
    Sppm all(lit, sampler, filter, settings());
    EXPECT_TRUE(all.whyNoPhotons().empty());
}

// One photon a pass, photons that all miss, points that none finds: finite, and black where there is nothing.
TEST(Sppm, EmptyPassesStayFinite) {
    const auto camera = std::make_shared<PinholeCamera>(Vec3(0, 1, 3), Vec3::Zero(), Vec3::UnitY(), 0.5, 6, 6);
    const SceneObject floor = diffuseRectangle({-1, 0, -1}, {0, 0, 2}, {2, 0, 0}, Color::Constant(0.7));
    // A single wall: whatever it scatters meets nothing, so no photon lies anywhere.
    const Scene scene({{floor}, {std::make_shared<PointLight>(Vec3(0, 1, 0), Color::Ones())}, Color::Zero(), camera});
    for (const RadiusRule rule : {RadiusRule::Pass, RadiusRule::Point}) {
        Sppm sppm(scene, sampler, filter, settings(rule, 1));
        SppmSettings without = settings(rule, 1);
        without.limits.maxLength = 2;
        Sppm direct(scene, sampler, filter, without);
        EXPECT_TRUE(sameBits(pictureOf(sppm, 20), pictureOf(direct, 20)));
        EXPECT_EQ(sppm.storedPhotons(), 0U);
        const Scene box(peersBox(8, 8));
        Sppm few(box, sampler, filter, settings(rule, 1));
        EXPECT_TRUE(std::isfinite(brightest(pictureOf(few, 30))));
    }
}

TEST(Sppm, SamePictureForAnyThreads) {
    const Scene scene(CausticScene{}.beforeMirror(24, 18));
    for (const RadiusRule rule : {RadiusRule::Pass, RadiusRule::Point}) {
        Sppm one(scene, sampler, filter, settings(rule, 5000));
        Sppm two(scene, sampler, filter, settings(rule, 5000));
        Sppm three(scene, sampler, filter, settings(rule, 5000));
        const Image picture = pictureOf(one, 5, 1);
        EXPECT_TRUE(sameBits(picture, pictureOf(two, 5, 2)));
        EXPECT_TRUE(sameBits(picture, pictureOf(three, 5, 3)));
    }
}

// Stopped after any pass, saved, read by another integrator: the same bits as in one go.
TEST(Sppm, GoesOnFromAFile) {
    const test::TemporaryFolder folder;
    const Scene scene(CausticScene{}.beforeMirror(16, 12));
    for (const RadiusRule rule : {RadiusRule::Pass, RadiusRule::Point}) {
        Sppm whole(scene, sampler, filter, settings(rule));
        const Image expected = pictureOf(whole, 6);
        for (std::int64_t stop = 1; stop < 6; ++stop) {
            Sppm first(scene, sampler, filter, settings(rule));
            saveCheckpoint(folder.path() / "state", "caustic", render(first, {.passes = stop}), first);
            Sppm second(scene, sampler, filter, settings(rule));
            Rendering rendering = loadCheckpoint(folder.path() / "state", "caustic", second);
            resume(second, {.passes = 6, .threads = 2}, rendering);
            EXPECT_TRUE(sameBits(expected, developed(second, rendering))) << "after pass " << stop;
        }
    }
}

std::string bytesOf(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

void writeBytes(const std::filesystem::path& file, const std::string& bytes) {
    std::ofstream(file, std::ios::binary) << bytes;
}

// Cut short at every byte, one bit changed anywhere, of another picture, another rule: refused by the file's name.
TEST(Sppm, RefusesDamagedFiles) {
    const test::TemporaryFolder folder;
    const auto file = folder.path() / "state";
    const Scene scene(CausticScene{}.beforeMirror(4, 3));
    Sppm sppm(scene, sampler, filter, settings(RadiusRule::Point, 200));
    saveCheckpoint(file, "caustic", render(sppm, {.passes = 2}), sppm);
    const std::string good = bytesOf(file);
    const auto expectRefused = [&](const std::string& bytes, const std::string& picture, RadiusRule rule) {
        writeBytes(file, bytes);
        Sppm other(scene, sampler, filter, settings(rule, 200));
        try {
            loadCheckpoint(file, picture, other);
            ADD_FAILURE() << bytes.size() << " bytes are taken";
        } catch (const InputError& error) {
            EXPECT_NE(std::string(error.what()).find("state"), std::string::npos) << error.what();
        }
    };
    for (std::size_t size = 0; size < good.size(); ++size)
        expectRefused(good.substr(0, size), "caustic", RadiusRule::Point);
    for (std::size_t at = 0; at < good.size(); at += 3) {
        std::string bad = good;
        bad[at] = static_cast<char>(bad[at] ^ 4);
        expectRefused(bad, "caustic", RadiusRule::Point);
    }
    expectRefused(good, "another scene", RadiusRule::Point);
    expectRefused(good, "caustic", RadiusRule::Pass);
    expectRefused(good + "x", "caustic", RadiusRule::Point);
}

// Numbers that no pass leaves behind, though the file's sum is right.
TEST(Sppm, RefusesStatisticsThatCannotBe) {
    const Scene scene(CausticScene{}.beforeMirror(2, 2));
    const auto stateOf = [](Real gridRadius, Real radius, Real photons, Real flux, std::int64_t passes) {
        std::ostringstream out;
        ByteWriter to(out);
        to.put(gridRadius);
        for (int i = 0; i < 4; ++i) {
            to.put(std::array<Real, 5>{radius, photons, flux, flux, flux});
            to.put(passes);
        }
        return out.str();
    };
    const auto load = [&](const std::string& bytes) {
        Sppm sppm(scene, sampler, filter, settings(RadiusRule::Point));
        std::istringstream in(bytes);
        ByteReader from(in, "state");
        sppm.load(from);
    };
    constexpr Real nan = std::numeric_limits<Real>::quiet_NaN();
    EXPECT_NO_THROW(load(stateOf(0.1, 0.1, 3, 2, 1)));
    EXPECT_THROW(load(stateOf(nan, 0.1, 3, 2, 1)), InputError);
    EXPECT_THROW(load(stateOf(0, 0.1, 3, 2, 1)), InputError);
    EXPECT_THROW(load(stateOf(0.1, nan, 3, 2, 1)), InputError);
    EXPECT_THROW(load(stateOf(0.1, -1, 3, 2, 1)), InputError);
    EXPECT_THROW(load(stateOf(0.1, 0.1, -3, 2, 1)), InputError);
    EXPECT_THROW(load(stateOf(0.1, 0.1, 3, nan, 1)), InputError);
    EXPECT_THROW(load(stateOf(0.1, 0.1, 3, 2, -1)), InputError);
}

TEST(Sppm, RefusesAPixelTwiceByRulePoint) {
    const Scene scene(CausticScene{}.beforeMirror(4, 3));
    const std::vector<PathId> twice = {{{1, 1}, 0}, {{2, 1}, 0}, {{1, 1}, 1}};
    Sppm byPoint(scene, sampler, filter, settings(RadiusRule::Point));
    EXPECT_THROW(byPoint.runPass({0, twice}, 1), InputError);
    Sppm byPass(scene, sampler, filter, settings());
    EXPECT_NO_THROW(byPass.runPass({0, twice}, 1));
}

// A scene of planes alone has no bounds, and a sky as its lamp.
TEST(Sppm, ScenesWithoutBoundsHaveARadius) {
    const Scene empty(SceneDescription{});
    EXPECT_GT(usualRadius(empty), 0);
    const auto sky = std::make_shared<ConstantEnvironment>(Color(1, 2, 3));
    const auto camera = std::make_shared<PinholeCamera>(Vec3(0, 1, 3), Vec3::Zero(), Vec3::UnitY(), 0.5, 4, 4);
    const Scene scene(
        {{diffuseRectangle({-1, 0, -1}, {0, 0, 2}, {2, 0, 0}, Color::Constant(0.7))}, {sky}, Color::Zero(), camera});
    Sppm sppm(scene, sampler, filter, settings());
    const Image picture = pictureOf(sppm, 256);
    EXPECT_NEAR(picture.at(2, 2).x(), 0.7, 0.05);
}

}  // namespace
}  // namespace caustic
