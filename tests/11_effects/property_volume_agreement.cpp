#include <gtest/gtest.h>

#include <vector>

#include "integrator/bidirectional_path_tracer.h"
#include "integrator/path_tracer.h"
#include "integrator/volume_sppm.h"
#include "light/point_light.h"
#include "medium/henyey_greenstein.h"
#include "medium/homogeneous_medium.h"
#include "modeler/diffuse_box.h"
#include "modeler/objects.h"
#include "shape/sphere.h"
#include "support/agreement.h"

namespace caustic {
namespace {

const PathLimits limits = {.maxLength = test::agreementSegments, .rouletteStart = 3};
constexpr Real fixedRadius = 1 - 1e-9;

// VolumeSppm without its bias: the same photons and paths within three radii, on surfaces and along rays. Bias is
// b₁R + b₂R², of edges and of curvature; L(R)/3 − 2 L(R/2) + 8/3 L(R/4) has neither.
class Extrapolated final : public Integrator {
public:
    Extrapolated(const Scene& scene, const Sampler& sampler, const PixelFilter& filter, MediumDirect direct)
        : Integrator(scene, sampler, filter) {
        for (const Real share : {1.0, 0.5, 0.25}) {
            VolumeSppmSettings settings;
            settings.limits = limits;
            settings.alpha = fixedRadius;
            settings.radius = share * 0.15;
            settings.beamRadius = share * 0.25;
            settings.photons = 4000;
            settings.direct = direct;
            parts_.emplace_back(scene, sampler, filter, settings);
        }
    }

    Rendering runPass(const Pass& pass, int threads) override {
        const Rendering wide = parts_[0].runPass(pass, threads);
        const Rendering half = parts_[1].runPass(pass, threads);
        const Rendering quarter = parts_[2].runPass(pass, threads);
        Rendering sum = {Film(wide.film.width(), wide.film.height()), wide.counts, 1, 0};
        for (const PathId& path : pass.paths) {
            const auto of = [&](const Rendering& part) { return part.film.value(path.pixel); };
            sum.film.add(path.pixel, path.index, of(wide) / 3 - 2 * of(half) + of(quarter) * (8.0 / 3));
        }
        return sum;
    }

    Color Li(const Ray& ray, const MediumStack& media, const PathNumbers& numbers, RayCounts& counts) const override {
        return parts_[2].Li(ray, media, numbers, counts);
    }

private:
    std::vector<VolumeSppm> parts_;
};

SceneObject fogAround(const Color& sigmaA, const Color& sigmaS, Real g) {
    return {.shape = std::make_shared<Sphere>(Vec3(0.1, 0, 0), 6),
            .interior = Interior{
                1, std::make_shared<HomogeneousMedium>(sigmaA, sigmaS, std::make_shared<HenyeyGreenstein>(g)), -1}};
}

// Boxes full of fog, the camera in it: forward scattering under a lamp; a ball of glass in fog that scatters backwards; a
// point light and a mirror ball.
std::vector<test::AgreementScene> scenes() {
    SceneDescription lamp = DiffuseBox{}.scene(test::agreementSide, test::agreementSide);
    lamp.objects.push_back(fogAround({0.02, 0.05, 0.1}, {0.3, 0.2, 0.5}, 0.5));
    SceneDescription glass = DiffuseBox{}.scene(test::agreementSide, test::agreementSide);
    glass.objects.push_back(fogAround({0, 0.1, 0.05}, {0.4, 0.3, 0.2}, -0.4));
    glass.objects.push_back(glassBall({0.1, 0, -0.3}, 0.45, 1.5));
    SceneDescription point = lamp;
    std::erase_if(point.objects, [](const SceneObject& one) { return one.emission != nullptr; });
    point.objects.push_back(mirrorBall({-0.3, 0.2, -0.5}, 0.4));
    point.lights = {std::make_shared<PointLight>(Vec3(0.35, -0.3, 0.3), Color(2, 1.8, 1.5))};
    return {{"fog under a lamp", lamp}, {"glass in fog", glass, true}, {"point light in fog", point}};
}

std::vector<test::AgreementMethod> methods(MediumDirect direct) {
    std::vector<test::AgreementMethod> all = test::agreementMethods();
    std::erase_if(all, [](const test::AgreementMethod& one) { return one.name == "light tracing"; });
    all.push_back({"photons in fog", [direct](const Scene& scene, const Sampler& sampler, const PixelFilter& filter) {
                       return std::make_unique<Extrapolated>(scene, sampler, filter, direct);
                   }});
    return all;
}

// Light that is scattered many times: path tracing by free flight, bidirectional path tracing, and photons gathered along
// rays with direct light by equi-angular sampling agree, block by block.
TEST(VolumeAgreement, PhotonsMeetPaths) {
    const test::Agreement agreement = test::compareMethods(scenes(), methods(MediumDirect::EquiAngular), 64, 1, 2);
    EXPECT_EQ(agreement.comparisons, 3 * 3 * 9);
    EXPECT_LE(agreement.largestT, agreement.mostT) << agreement.worst;
    EXPECT_NEAR(agreement.variance, agreement.expectedVariance, agreement.varianceBand) << agreement.worst;
    EXPECT_LE(agreement.largestMeanT, 5) << agreement.worst;
    EXPECT_EQ(agreement.badSamples, 0);
    EXPECT_LE(agreement.largestError, 0.02) << "too few paths to say anything";
}

// The report's way, where all is photons, under a lamp with an extent: next to a point the density has no bias of such a form.
TEST(VolumeAgreement, PhotonsAloneMeetPaths) {
    std::vector<test::AgreementMethod> two = methods(MediumDirect::Photons);
    two.erase(two.begin() + 1);
    const std::vector<test::AgreementScene> one = {scenes().front()};
    const test::Agreement agreement = test::compareMethods(one, two, 64, 1, 2);
    EXPECT_TRUE(agreement.agrees()) << agreement.worst << ": " << agreement.largestT << ", " << agreement.largestMeanT;
    EXPECT_LE(agreement.largestError, 0.02) << "too few paths to say anything";
}

// The power of it: a method that is a tenth too bright is found.
TEST(VolumeAgreement, OneThatIsTooBrightIsFound) {
    std::vector<test::AgreementMethod> two = methods(MediumDirect::EquiAngular);
    two.erase(two.begin() + 1);
    two.back() = test::brightened(two.back(), 0.1);
    EXPECT_FALSE(test::compareMethods({scenes().front()}, two, 64, 1, 2).agrees());
}

}  // namespace
}  // namespace caustic
