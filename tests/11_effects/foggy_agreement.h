#pragma once

#include <memory>
#include <vector>

#include "integrator/volume_sppm.h"
#include "medium/henyey_greenstein.h"
#include "medium/homogeneous_medium.h"
#include "modeler/diffuse_box.h"
#include "modeler/objects.h"
#include "shape/sphere.h"
#include "support/agreement.h"
#include "support/extrapolated.h"

namespace caustic::test {

/// VolumeSppm without its bias, on surfaces and along rays.
inline std::unique_ptr<Integrator> unbiased(const Scene& scene, const Sampler& sampler, const PixelFilter& filter,
                                            MediumDirect direct) {
    return std::make_unique<Extrapolated<VolumeSppm>>(scene, sampler, filter, [direct](Real share) {
        VolumeSppmSettings settings;
        settings.limits = {.maxLength = agreementSegments, .rouletteStart = 3};
        settings.alpha = 1 - 1e-9;  // the radius stays
        settings.radius = share * 0.15;
        settings.beamRadius = share * 0.25;
        settings.photons = 4000;
        settings.direct = direct;
        return settings;
    });
}

/// A ball of fog around everything.
inline SceneObject fogAround(const Color& sigmaA, const Color& sigmaS, Real g) {
    return {.shape = std::make_shared<Sphere>(Vec3(0.1, 0, 0), 6),
            .interior = Interior{
                1, std::make_shared<HomogeneousMedium>(sigmaA, sigmaS, std::make_shared<HenyeyGreenstein>(g)), -1}};
}

/// Boxes full of fog, the camera in it: a mirror ball in fog that scatters forwards; a ball of glass in fog that
/// scatters backwards. No light at a point: paths that come close to one have no finite variance.
inline std::vector<AgreementScene> foggyScenes() {
    SceneDescription lamp = DiffuseBox{}.scene(agreementSide, agreementSide);
    lamp.objects.push_back(fogAround({0.02, 0.05, 0.1}, {0.3, 0.2, 0.5}, 0.5));
    lamp.objects.push_back(mirrorBall({-0.3, 0.2, -0.5}, 0.4));
    SceneDescription glass = DiffuseBox{}.scene(agreementSide, agreementSide);
    glass.objects.push_back(fogAround({0, 0.1, 0.05}, {0.4, 0.3, 0.2}, -0.4));
    glass.objects.push_back(glassBall({0.1, 0, -0.3}, 0.45, 1.5));
    return {{"fog under a lamp", lamp}, {"glass in fog", glass}};
}

/// Path tracing by free flight, bidirectional path tracing, photons in fog.
inline std::vector<AgreementMethod> foggyMethods(MediumDirect direct) {
    std::vector<AgreementMethod> all = agreementMethods();
    std::erase_if(all, [](const AgreementMethod& one) { return one.name == "light tracing"; });
    all.push_back({"photons in fog", [direct](const Scene& scene, const Sampler& sampler, const PixelFilter& filter) {
                       return unbiased(scene, sampler, filter, direct);
                   }});
    return all;
}

}  // namespace caustic::test
