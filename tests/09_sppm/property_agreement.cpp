#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "camera/pinhole_camera.h"
#include "integrator/bidirectional_path_tracer.h"
#include "integrator/sppm.h"
#include "material/dielectric_material.h"
#include "medium/absorbing_medium.h"
#include "modeler/diffuse_box.h"
#include "modeler/objects.h"
#include "modeler/peers_box.h"
#include "shape/sphere.h"
#include "support/agreement.h"
#include "support/extrapolated.h"

namespace caustic {
namespace {

const PathLimits limits = {.maxLength = test::agreementSegments, .rouletteStart = 3};
constexpr Real fixedRadius = 1 - 1e-9;

// SPPM without its bias.
std::unique_ptr<Integrator> unbiased(const Scene& scene, const Sampler& sampler, const PixelFilter& filter) {
    return std::make_unique<test::Extrapolated<Sppm>>(scene, sampler, filter, [&](Real share) {
        SppmSettings settings;
        settings.limits = limits;
        settings.alpha = fixedRadius;
        settings.radius = share * 2.5 * usualRadius(scene);
        settings.photons = 6000;
        return settings;
    });
}

// A diffuse box, the peers' box, a glossy floor, and a ball of red glass in a box.
std::vector<test::AgreementScene> scenes() {
    std::vector<test::AgreementScene> all = {
        {"diffuse box", DiffuseBox{}.scene(test::agreementSide, test::agreementSide)},
        {"peers' box", peersBox(test::agreementSide, test::agreementSide)}};
    for (const test::AgreementScene& one : test::agreementScenes()) {
        if (one.name == "glossy") all.push_back(one);
    }
    SceneDescription red = DiffuseBox{}.scene(test::agreementSide, test::agreementSide);
    SceneObject ball = glassBall({0.2, 0, -0.45}, 0.5, 1.5);
    ball.interior->medium = std::make_shared<AbsorbingMedium>(Color(0.3, 2, 1.5));
    red.objects.push_back(ball);
    all.push_back({"red glass", red});
    return all;
}

std::vector<test::AgreementMethod> methods() {
    return {{"SPPM without bias", unbiased},
            {"bidirectional", [](const Scene& scene, const Sampler& sampler, const PixelFilter& filter) {
                 return std::make_unique<BidirectionalPathTracer>(scene, sampler, filter, limits);
             }}};
}

// Two methods that share the walk and nothing else.
TEST(SppmAgreement, MeetsBidirectionalPathTracingBlockByBlock) {
    const test::Agreement agreement = test::compareMethods(scenes(), methods(), 64, 2, 2);
    EXPECT_EQ(agreement.comparisons, 4 * 9);
    EXPECT_LE(agreement.largestT, agreement.mostT) << agreement.worst;
    EXPECT_LE(agreement.largestMeanT, 5) << agreement.worst;
    EXPECT_EQ(agreement.badSamples, 0);
    EXPECT_LE(agreement.largestError, 0.02) << "too few paths to say anything";
}

// The power of that test.
TEST(SppmAgreement, FindsAPictureThatIsTooBright) {
    std::vector<test::AgreementMethod> both = methods();
    both[0] = test::brightened(both[1], 0.1);
    EXPECT_FALSE(test::compareMethods({scenes()[0]}, both, 64, 2, 2).agrees());
}

}  // namespace
}  // namespace caustic
