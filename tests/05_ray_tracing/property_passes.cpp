// Passes: any threads, any process, stopped and resumed, the picture is the same to the last bit.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <sstream>

#include "camera/box_filter.h"
#include "camera/pinhole_camera.h"
#include "camera/tent_filter.h"
#include "core/error.h"
#include "integrator/checkpoint.h"
#include "integrator/render.h"
#include "sampling/independent_sampler.h"
#include "support/temporary_folder.h"

namespace caustic {
namespace {

constexpr int width = 7;
constexpr int height = 5;
const IndependentSampler independent(3);
const TentFilter tent;

Scene emptyScene() {
    SceneDescription description;
    description.camera =
        std::make_shared<PinholeCamera>(Vec3(0.3, 1, 4), Vec3::Zero(), Vec3::UnitY(), 0.7, width, height);
    return Scene(description);
}

// A value of each pixel and a splat somewhere from each path, both by chance. Keeps a sum of what each pass brought,
// times the pass's number: a method whose passes can't be told apart from the others' would get it wrong.
class Keeper final : public Integrator {
public:
    explicit Keeper(const Scene& scene) : Integrator(scene, independent, tent) {}

    Color Li(const Ray& ray, const MediumStack&, const PathNumbers& numbers, RayCounts& counts) const override {
        ++counts.rays;
        return Color(ray.direction.x(), numbers.number(Dimension::vertex(0, VertexUse::Lobe)), kept_ * 1e-3);
    }

    Color tracePath(const PathId& path, std::vector<Splat>& splats, RayCounts& counts) const override {
        const PathNumbers numbers = sampler().start(lightStream, path.pixel, path.index);
        const Vec2 u = numbers.pair(Dimension::emissionPoint());
        splats.push_back({{u.x() * width, u.y() * height}, Color(u.y(), 1 / (u.x() + 0.01), 0.1)});
        return Integrator::tracePath(path, splats, counts);
    }

    Rendering runPass(const Pass& pass, int threads) override {
        Rendering rendering = Integrator::runPass(pass, threads);
        for (const PathId& path : pass.paths)
            kept_ += static_cast<Real>(pass.number + 1) * rendering.film.value(path.pixel).y();
        return rendering;
    }

    void develop(Image& picture) const override { picture.set(0, 0, Color::Constant(kept_)); }
    void save(ByteWriter& to) const override { to.put(kept_); }
    void load(ByteReader& from) override { kept_ = from.get<Real>(); }

private:
    Real kept_ = 0;
};

std::string bytesOf(const Rendering& rendering) {
    std::ostringstream out;
    ByteWriter to(out);
    Rendering untimed = rendering;
    untimed.seconds = 0;
    untimed.save(to, "picture");
    return out.str();
}

std::string bytesOf(const Integrator& integrator, const Rendering& rendering) {
    std::ostringstream out;
    ByteWriter to(out);
    integrator.save(to);
    return bytesOf(rendering) + out.str();
}

std::string readFile(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

TEST(Passes, AreTheSameWithAnyThreads) {
    const Scene scene = emptyScene();
    Keeper one(scene);
    const std::string expected = bytesOf(one, render(one, {.passes = 6}));
    for (const int threads : {2, 3, 8}) {
        Keeper shared(scene);
        EXPECT_EQ(bytesOf(shared, render(shared, {.passes = 6, .threads = threads})), expected) << threads;
    }
}

// As over MPI: each pass by itself, sent as bytes, merged in order.
TEST(Passes, MergedInOrderMakeThePictureOfOneProcess) {
    const Scene scene = emptyScene();
    Keeper alone(scene);
    const Rendering expected = render(alone, {.passes = 5});
    Keeper remote(scene);
    Rendering merged = {Film(width, height), {}};
    for (int number = 0; number < 5; ++number) {
        const std::vector<PathId> paths = pathsOfAllPixels(scene.camera(), number);
        std::stringstream wire;
        ByteWriter to(wire);
        remote.runPass({number, paths}, 2).save(to, "picture");
        ByteReader from(wire, "wire");
        Rendering pass = {Film(width, height), {}};
        pass.load(from, "picture");
        merged.merge(pass);
    }
    EXPECT_EQ(bytesOf(merged), bytesOf(expected));
    EXPECT_EQ(merged.passes, 5);
}

TEST(Passes, StoppedAndResumedMakeTheSamePicture) {
    const Scene scene = emptyScene();
    const test::TemporaryFolder folder;
    const auto file = folder.path() / "rendering.checkpoint";
    Keeper whole(scene);
    const Rendering expected = render(whole, {.passes = 6});
    for (int stop = 1; stop < 6; ++stop) {
        Keeper first(scene);
        const Rendering half =
            render(first, {.passes = 6, .look = [stop](const Rendering& soFar) { return soFar.passes < stop; }});
        saveCheckpoint(file, "keeper 3", half, first);
        Keeper second(scene);
        Rendering rest = loadCheckpoint(file, "keeper 3", second);
        EXPECT_EQ(rest.passes, stop);
        EXPECT_EQ(rest.seconds, half.seconds);
        resume(second, {.passes = 6, .threads = 2}, rest);
        EXPECT_EQ(bytesOf(second, rest), bytesOf(whole, expected)) << "stopped after pass " << stop;
        EXPECT_TRUE((developed(second, rest).at(0, 0) == developed(whole, expected).at(0, 0)).all());
    }
    Keeper third(scene);
    Rendering done = loadCheckpoint(file, "keeper 3", third);
    resume(third, {.passes = 3}, done);
    EXPECT_EQ(done.passes, 5) << "what is over its limit already stays as it is";
}

TEST(Passes, GoOverChosenPixelsOnly) {
    const Scene scene = emptyScene();
    Keeper keeper(scene);
    const Rendering rendering =
        render(keeper, {.choose = [](const Rendering& soFar) -> std::vector<PathId> {
                   if (soFar.passes == 4) return {};
                   return {{{1, 2}, 2 * soFar.passes}, {{1, 2}, 2 * soFar.passes + 1}, {{6, 4}, soFar.passes}};
               }});
    EXPECT_EQ(rendering.passes, 4);
    EXPECT_EQ(rendering.film.samples({1, 2}), 8);
    EXPECT_EQ(rendering.film.samples({6, 4}), 4);
    EXPECT_EQ(rendering.film.samples({0, 0}), 0);
    EXPECT_EQ(rendering.counts.rays, 12);
}

// What is wrong with a checkpoint of these bytes; nothing when it is taken.
std::string complaintOf(const std::string& bytes, const Scene& scene) {
    std::istringstream in(bytes);
    ByteReader from(in, "some.checkpoint");
    Keeper keeper(scene);
    try {
        loadCheckpoint(from, "keeper 3", keeper);
    } catch (const InputError& error) {
        EXPECT_EQ(error.place().file, "some.checkpoint");
        return error.reason();
    }
    return "";
}

TEST(Checkpoint, IsRefusedWhenItIsCutShortOrChangedAnywhere) {
    const Scene scene = emptyScene();
    const test::TemporaryFolder folder;
    const auto file = folder.path() / "rendering.checkpoint";
    Keeper keeper(scene);
    saveCheckpoint(file, "keeper 3", render(keeper, {.passes = 2}), keeper);
    const std::string bytes = readFile(file);
    EXPECT_EQ(complaintOf(bytes, scene), "");
    for (std::size_t length = 0; length < bytes.size(); ++length)
        ASSERT_EQ(complaintOf(bytes.substr(0, length), scene), "is cut short") << "after " << length << " bytes";
    for (std::size_t place = 0; place < bytes.size(); ++place) {
        std::string changed = bytes;
        changed[place] = static_cast<char>(changed[place] ^ 0x10);
        ASSERT_NE(complaintOf(changed, scene), "") << "byte " << place << " was changed";
    }
    EXPECT_EQ(complaintOf(bytes + "x", scene), "goes on after its end");
    std::filesystem::resize_file(file, bytes.size() - 1);
    EXPECT_THROW(loadCheckpoint(file, "keeper 3", keeper), InputError);
    std::filesystem::remove(file);
    EXPECT_THROW(loadCheckpoint(file, "keeper 3", keeper), InputError);
}

std::string refusal(const std::string& bytes, const std::string& picture, Film& film) {
    std::istringstream in(bytes);
    ByteReader from(in, "some.film");
    try {
        film.load(from, picture);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

TEST(Film, RefusesWhatIsOfAnotherPictureSizeOrVersion) {
    Film film(3, 2);
    film.add({2, 1}, 0, Color(1, 2, 3));
    std::ostringstream out;
    ByteWriter to(out);
    film.save(to, "box seed=1");
    const std::string bytes = out.str();

    Film other(3, 2);
    other.add({0, 0}, 0, Color::Ones());
    EXPECT_EQ(refusal(bytes, "box seed=2", other),
              "some.film: is of another picture, not of 'box seed=2' (got 'box seed=1')");
    EXPECT_EQ(other.value({0, 0}).x(), 1) << "a film that was refused leaves the old one";
    Film turned(2, 3);
    EXPECT_EQ(refusal(bytes, "box seed=1", turned), "some.film: is of another size, not of 2 x 3 pixels (got '3 x 2')");
    std::string later = bytes;
    ++later[8 + 12];
    EXPECT_EQ(refusal(later, "box seed=1", other), "some.film: is of another version, not of 1 (got '2')");
    EXPECT_NE(refusal("Some text of a person, not a film at all.", "box seed=1", other), "");
    EXPECT_EQ(refusal(bytes, "box seed=1", other), "");
    EXPECT_EQ(other.value({2, 1}).z(), 3);
    EXPECT_EQ(other.samples({0, 0}), 0);
}

TEST(Film, MergesWhatIsNotANumberToo) {
    Film first(3, 2);
    Film second(3, 2);
    const Color bad = Color::Constant(std::nan(""));
    second.splat({std::nan(""), 1e300}, bad, BoxFilter());
    second.add({1, 1}, 7, bad);
    first.merge(second);
    second.add({0, 1}, 8, bad);
    first.merge(second);
    EXPECT_EQ(first.badSamples(), 5);
    EXPECT_EQ(first.firstBad()->pixel.y, 1) << "the nearest pixel of the film";
    EXPECT_THROW(first.merge(Film(2, 3)), InputError);
    const Scene scene = emptyScene();
    EXPECT_THROW(requireFinite({first, {}}), std::runtime_error);
    EXPECT_NO_THROW(requireFinite({Film(1, 1), {}}));
}

}  // namespace
}  // namespace caustic
