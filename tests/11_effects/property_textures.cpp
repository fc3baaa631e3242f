#include <gtest/gtest.h>

#include <cmath>

#include "camera/box_filter.h"
#include "camera/pinhole_camera.h"
#include "core/error.h"
#include "core/random.h"
#include "integrator/path_tracer.h"
#include "integrator/render.h"
#include "light/area_light.h"
#include "light/weighted_shape.h"
#include "material/diffuse_material.h"
#include "modeler/diffuse_box.h"
#include "sampling/independent_sampler.h"
#include "shape/rectangle.h"
#include "shape/sphere.h"
#include "support/agreement.h"
#include "support/density_test.h"
#include "test_maps.h"
#include "texture/constant_texture.h"
#include "texture/image_texture.h"

namespace caustic {
namespace {

SurfacePoint at(Real u, Real v) {
    SurfacePoint point;
    point.uv = {u, v};
    return point;
}

std::shared_ptr<const Image> shared(Image image) { return std::make_shared<const Image>(std::move(image)); }

// Upper row red and green, lower row blue and white.
std::shared_ptr<const Image> fourPixels() {
    Image image(2, 2);
    image.set(0, 0, Color(1, 0, 0));
    image.set(1, 0, Color(0, 1, 0));
    image.set(0, 1, Color(0, 0, 1));
    image.set(1, 1, Color(1, 1, 1));
    return shared(image);
}

TEST(ImageTexture, StandsUprightAndRepeats) {
    for (const Lookup lookup : {Lookup::Nearest, Lookup::Bilinear}) {
        const ImageTexture texture(fourPixels(), lookup);
        const auto shows = [&](Real u, Real v, const Color& color) {
            EXPECT_LT((texture.at(at(u, v)) - color).abs().maxCoeff(), 1e-12) << u << ", " << v;
        };
        shows(0.25, 0.75, Color(1, 0, 0));
        shows(0.75, 0.75, Color(0, 1, 0));
        shows(0.25, 0.25, Color(0, 0, 1));
        shows(0.75, 0.25, Color(1, 1, 1));
        shows(3.25, -1.75 + 0.5, Color(1, 0, 0));
        shows(-0.25, 7.25, Color(1, 1, 1));
    }
    const ImageTexture smooth(fourPixels(), Lookup::Bilinear);
    EXPECT_LT((smooth.at(at(0.5, 0.75)) - Color(0.5, 0.5, 0)).abs().maxCoeff(), 1e-12);
    EXPECT_LT((smooth.at(at(0, 0.75)) - Color(0.5, 0.5, 0)).abs().maxCoeff(), 1e-12) << "goes round where it repeats";
    const ImageTexture clamped(fourPixels(), Lookup::Bilinear, Wrap::Clamp);
    EXPECT_LT((clamped.at(at(0, 0.75)) - Color(1, 0, 0)).abs().maxCoeff(), 1e-12);
    EXPECT_LT((clamped.at(at(-8, 0.75)) - Color(1, 0, 0)).abs().maxCoeff(), 1e-12);
    const ImageTexture tiled(fourPixels(), Lookup::Nearest, Wrap::Repeat, {3, 5});
    EXPECT_TRUE((tiled.at(at(0.25 / 3, 0.75 / 5)) == Color(1, 0, 0)).all());
    EXPECT_TRUE((tiled.at(at(2.75 / 3, 4.25 / 5)) == Color(1, 1, 1)).all());
}

TEST(ImageTexture, SaysMeanAndBounds) {
    const ImageTexture texture(fourPixels());
    EXPECT_TRUE((texture.mean() == Color(0.5, 0.5, 0.5)).all());
    EXPECT_TRUE((texture.largest() == Color(1, 1, 1)).all());
    EXPECT_FALSE(texture.constant());
}

TEST(ImageTexture, RefusesWhatIsNoTexture) {
    EXPECT_THROW(ImageTexture(nullptr), InputError);
    for (const float bad : {-1e-6F, std::nanf(""), 1.0F / 0.0F}) {
        Image image(3, 2, Color::Ones());
        image.data()[7] = bad;
        EXPECT_THROW(ImageTexture(shared(image)), InputError);
    }
    for (const Real tiles : {0.0, -1.0, std::nan("")})
        EXPECT_THROW(ImageTexture(fourPixels(), Lookup::Nearest, Wrap::Repeat, {1, tiles}), InputError);
    EXPECT_THROW(DiffuseMaterial(std::make_shared<ImageTexture>(shared(Image(2, 2, Color(0.5, 1.5, 0.5))))),
                 InputError);
}

// A box with a lamp and a back wall of its own.
SceneDescription boxWithLamp(const std::shared_ptr<const Texture>& radiance, const std::shared_ptr<const Shape>& lamp,
                             const std::shared_ptr<const Texture>& wall, int side) {
    SceneDescription scene = DiffuseBox{}.scene(side, side);
    std::erase_if(scene.objects, [](const SceneObject& one) { return one.emission != nullptr; });
    scene.objects.push_back({lamp, nullptr, std::nullopt, radiance});
    scene.objects.push_back({std::make_shared<Rectangle>(Vec3(-1, 0.9, -1), Vec3(2, 0, 0), Vec3(0, 0, 2)),
                             std::make_shared<DiffuseMaterial>(wall)});
    return scene;
}

std::shared_ptr<const Shape> ceilingLamp() {
    return std::make_shared<Rectangle>(Vec3(-0.3, 0.4, 0.99), Vec3(0.7, 0, 0), Vec3(0, -0.8, 0));
}

TEST(ImageTexture, OneColourIsAConstantTexture) {
    const Color color(0.75, 0.5, 0.1875);
    const IndependentSampler sampler(5);
    const BoxFilter filter;
    const auto rendered = [&](const std::shared_ptr<const Texture>& texture) {
        const Scene scene(boxWithLamp(texture, ceilingLamp(), texture, 20));
        PathTracer tracer(scene, sampler, filter, {});
        return render(tracer, {.passes = 3});
    };
    const Rendering constant = rendered(std::make_shared<ConstantTexture>(color));
    for (const Lookup lookup : {Lookup::Nearest, Lookup::Bilinear}) {
        const Rendering image = rendered(std::make_shared<ImageTexture>(shared(Image(7, 3, color)), lookup));
        EXPECT_TRUE(test::sameBits(constant.film.image(), image.film.image()));
        EXPECT_EQ(image.counts.textureLookups, 0);
    }
}

// A lamp that shines as an image, sampled by its brightness or evenly, by all methods.
TEST(WeightedShape, LampsAgree) {
    const Image image = test::uglyMap(6, 5, 3);
    std::vector<test::AgreementScene> scenes;
    const auto texture = std::make_shared<ImageTexture>(shared(image));
    const auto wall = std::make_shared<ConstantTexture>(Color(0.3, 0.5, 0.7));
    scenes.push_back({"weighted", boxWithLamp(texture, std::make_shared<WeightedShape>(ceilingLamp(), image), wall,
                                              test::agreementSide)});
    const test::Agreement agreement = test::compareMethods(scenes, test::agreementMethods(), 48, 1, 2);
    EXPECT_TRUE(agreement.agrees()) << agreement.worst << ": " << agreement.largestT << " of " << agreement.mostT
                                    << ", means " << agreement.largestMeanT << ", variance " << agreement.variance;

    // Evenly sampled, by path tracing alone: the same mean.
    const IndependentSampler sampler(5);
    const BoxFilter filter;
    const auto mean = [&](const std::shared_ptr<const Shape>& lamp) {
        SceneDescription description = scenes.back().description;
        for (SceneObject& one : description.objects) {
            if (one.emission) one.shape = lamp;
        }
        const Scene scene(description);
        PathTracer tracer(scene, sampler, filter, {});
        const Image picture = render(tracer, {.passes = 40, .threads = 2}).film.image();
        Real sum = 0;
        for (const float value : picture.data()) sum += Real(value);
        return sum;
    };
    EXPECT_NEAR(mean(ceilingLamp()) / mean(std::make_shared<WeightedShape>(ceilingLamp(), image)), 1, 0.02);
}

TEST(WeightedShape, PointsHaveTheirDensity) {
    const Vec3 corner(1, -2, 0.5);
    const Vec3 edgeU(0.5, 0, 1.2);
    const Vec3 edgeV(0, 3, 0);
    const auto lamp = std::make_shared<Rectangle>(corner, edgeU, edgeV);
    const Real area = edgeU.norm() * edgeV.norm();
    for (const Wrap wrap : {Wrap::Clamp, Wrap::Repeat}) {
        const WeightedShape shape(lamp, test::uglyMap(8, 4, 5), wrap);
        test::DensityTest density(test::planeCells, 100'000, 3);
        const test::PlaceSampling sampling = {
            [&](Random& random) -> std::optional<test::Place> {
                const Real x = random.uniform();
                const auto sample = shape.sampleArea({x, random.uniform()});
                EXPECT_NEAR(sample->pdfA / shape.pdfA(sample->at), 1, 1e-6);
                return test::Place{sample->at.uv.x(), sample->at.uv.y(), 0, 0};
            },
            [&](const test::Place& place) { return shape.pdfA(at(place[0], place[1])) * area; }};
        EXPECT_GT(density.probability(sampling), 1e-6);
    }
}

TEST(WeightedShape, RefusesWhatItCannotSample) {
    const Image image = test::uglyMap(4, 4, 1);
    EXPECT_THROW(WeightedShape(nullptr, image), InputError);
    EXPECT_THROW(WeightedShape(std::make_shared<Sphere>(Vec3::Zero(), 1), image), InputError);
    EXPECT_THROW(WeightedShape(ceilingLamp(), Image(4, 4)), InputError) << "black";
}

}  // namespace
}  // namespace caustic
