#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "camera/box_filter.h"
#include "camera/thin_lens_camera.h"
#include "core/error.h"
#include "core/random.h"
#include "integrator/bidirectional_path_tracer.h"
#include "integrator/path_tracer.h"
#include "integrator/render.h"
#include "modeler/diffuse_box.h"
#include "modeler/objects.h"
#include "sampling/independent_sampler.h"
#include "sampling/sobol_sampler.h"
#include "support/agreement.h"
#include "test_maps.h"

namespace caustic {
namespace {

const BoxFilter filter;

std::shared_ptr<ThinLensCamera> boxCamera(int side, Real radius) {
    return std::make_shared<ThinLensCamera>(Vec3(0.4, -3.6, 0.5), Vec3(-0.1, 0, -0.1), Vec3(0.1, 0, 1), 0.6, side, side,
                                            radius, 2.9);
}

TEST(ThinLensCamera, WithoutALensThePictureIsThePinholes) {
    for (const bool both : {false, true}) {
        SceneDescription description = DiffuseBox{.mirror = true}.scene(20, 16);
        description.camera =
            std::make_shared<PinholeCamera>(Vec3(0.4, -3.6, 0.5), Vec3(-0.1, 0, -0.1), Vec3(0.1, 0, 1), 0.6, 20, 16);
        const Scene pinhole(description);
        description.camera = std::make_shared<ThinLensCamera>(Vec3(0.4, -3.6, 0.5), Vec3(-0.1, 0, -0.1),
                                                              Vec3(0.1, 0, 1), 0.6, 20, 16, 0, 2.9);
        const Scene lens(description);
        const SobolSampler sampler(3);
        const auto rendered = [&](const Scene& scene) -> Rendering {
            if (both) {
                BidirectionalPathTracer tracer(scene, sampler, filter, {});
                return render(tracer, {.passes = 3});
            }
            PathTracer tracer(scene, sampler, filter, {});
            return render(tracer, {.passes = 3});
        };
        const Rendering first = rendered(pinhole);
        const Rendering second = rendered(lens);
        EXPECT_TRUE(test::sameBits(first.film.image(), second.film.image()));
        EXPECT_EQ(second.counts.lensSamples, 0) << "no numbers for a lens that isn't there";
    }
}

// Light paths that are seen through a point of the lens, and eye paths that start there: one picture.
TEST(ThinLensCamera, MethodsAgreeThroughALens) {
    SceneDescription description = DiffuseBox{}.scene(test::agreementSide, test::agreementSide);
    description.camera = boxCamera(test::agreementSide, 0.25);
    const test::Agreement agreement =
        test::compareMethods({{"lens", description, false}}, test::agreementMethods(), 48, 1, 2);
    EXPECT_TRUE(agreement.agrees()) << agreement.worst << ": " << agreement.largestT << " of " << agreement.mostT
                                    << ", means " << agreement.largestMeanT << ", variance " << agreement.variance;
    EXPECT_LE(agreement.largestError, 0.02);
}

// The way there and back: what sampleRay sends out from a lens point, sampleImportance sees at the same film point
// through the same one; densities and We as the camera's contract has them.
TEST(ThinLensCamera, SeesWhatItLooksAt) {
    Random random(7, {1});
    const auto camera = boxCamera(40, 0.3);
    for (int i = 0; i < 2000; ++i) {
        const Vec2 film(random.uniform(0.01, 39.99), random.uniform(0.01, 39.99));
        const Vec2 u(random.uniform(), random.uniform());
        const Ray ray = camera->sampleRay(film, u);
        const Vec3 point = ray.at(std::pow(10, random.uniform(-1, 2)));
        const auto seen = camera->sampleImportance(point, u);
        ASSERT_TRUE(seen);
        ASSERT_LT((seen->film - film).norm(), 1e-6);
        ASSERT_LT((seen->lens - ray.origin).norm(), 1e-12);
        const CameraPdf pdf = camera->pdf(ray);
        ASSERT_EQ(pdf.pdfA, seen->pdfA);
        // A film point of density 1 over width · height pixels: We cos = pdfA · pdfW · their number.
        ASSERT_NEAR(seen->We * seen->cosine / (pdf.pdfA * pdf.pdfW * 1600), 1, 1e-9);
    }
    EXPECT_FALSE(camera->sampleImportance(Vec3(0.4, -30, 0.5), {0.3, 0.2})) << "behind the camera";
    EXPECT_EQ(camera->pdf({Vec3(0.4, -3.6, 0.5), Vec3(0, -1, 0)}).pdfW, 0);
}

// A lamp smaller than its blur, rendered: its light is spread over a disc of the closed form's diameter, whose
// second moment is a sixteenth of the diameter squared along each axis.
TEST(ThinLensCamera, BlurHasTheClosedFormsSize) {
    constexpr int side = 48;
    const SobolSampler sampler(3);
    for (const auto& [depth, focus] : {std::pair(3.0, 6.0), {9.0, 4.0}, {5.0, 50.0}}) {
        SceneDescription description;
        constexpr Real lamp = 0.06;
        description.objects = {
            rectangleLamp({-lamp / 2, -lamp / 2, -depth}, {lamp, 0, 0}, {0, lamp, 0}, Color::Ones())};
        const auto camera =
            std::make_shared<ThinLensCamera>(Vec3::Zero(), -Vec3::UnitZ(), Vec3::UnitY(), 0.12, side, side, 0.1, focus);
        description.camera = camera;
        const Scene scene(description);
        PathTracer tracer(scene, sampler, filter, {});
        const Image picture = render(tracer, {.passes = 512, .threads = 2}).film.image();
        Real sum = 0;
        Vec2 first = Vec2::Zero();
        Vec2 second = Vec2::Zero();
        for (int y = 0; y < side; ++y) {
            for (int x = 0; x < side; ++x) {
                const Vec2 at(x + 0.5, y + 0.5);
                sum += picture.at(x, y).x();
                first += picture.at(x, y).x() * at;
                second += picture.at(x, y).x() * at.cwiseAbs2();
            }
        }
        const Vec2 variance = second / sum - (first / sum).cwiseAbs2();
        // The square of the lamp and that of a pixel blur it further: a twelfth of their sides squared.
        const Real pixels = side * lamp / (2 * std::tan(0.06) * depth);
        const Real own = (pixels * pixels + 1) / 12;
        const Real diameter = 4 * std::sqrt(variance.mean() - own);
        EXPECT_NEAR(diameter / camera->circleOfConfusion(depth), 1, 0.02) << "depth " << depth << ", focus " << focus;
    }
}

TEST(ThinLensCamera, RefusesWhatIsNoLens) {
    const auto made = [](Real radius, Real focus) {
        return ThinLensCamera(Vec3::Zero(), Vec3::UnitX(), Vec3::UnitZ(), 0.5, 4, 4, radius, focus);
    };
    constexpr Real infinite = std::numeric_limits<Real>::infinity();
    for (const Real radius : {-1e-9, std::nan(""), infinite}) EXPECT_THROW(made(radius, 1), InputError);
    for (const Real focus : {0.0, -1.0, std::nan(""), infinite}) EXPECT_THROW(made(0.1, focus), InputError);
    EXPECT_THROW(ThinLensCamera(Vec3::Zero(), Vec3::Zero(), Vec3::UnitZ(), 0.5, 4, 4, 0.1, 1), InputError);
    EXPECT_THROW(ThinLensCamera(Vec3::Zero(), Vec3::UnitX(), Vec3::UnitX(), 0.5, 4, 4, 0.1, 1), InputError);
    EXPECT_THROW(ThinLensCamera(Vec3::Zero(), Vec3::UnitX(), Vec3::UnitZ(), 0.5, 0, 4, 0.1, 1), InputError);
}

}  // namespace
}  // namespace caustic
