#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "integrator/integrator.h"

namespace caustic::test {

/// A scene that several methods are to show alike.
struct AgreementScene {
    std::string name;
    SceneDescription description;   ///< with a camera of `agreementSide`² pixels
    bool eyeMeetsSpecular = false;  ///< whether a mirror or smooth glass is in view: light tracing can't show that
};

/// Pixels of an agreement picture's side; blocks are of 16 × 16.
inline constexpr int agreementSide = 48;
/// Paths from the eye to the light have no more segments.
inline constexpr int agreementSegments = 8;

/// Five scenes: a diffuse box; a coarse ball of a mesh with interpolated normals in it; a glass ball in it; under a
/// point lamp, a ball with Phong's highlight beside a diffuse one; under a large lamp, a rough metal ball on a glossy
/// floor.
std::vector<AgreementScene> agreementScenes();

/// Makes an integrator of a method.
using MakeIntegrator =
    std::function<std::unique_ptr<Integrator>(const Scene& scene, const Sampler& sampler, const PixelFilter& filter)>;

/// One of the methods.
struct AgreementMethod {
    std::string name;
    MakeIntegrator make;
    bool sees = true;  ///< whether it can show what is seen over delta lobes
};

/// Path tracing with both ways, light tracing, bidirectional path tracing.
std::vector<AgreementMethod> agreementMethods();

/// The same method with every contribution larger by a share: a mistake that the test has to find.
AgreementMethod brightened(const AgreementMethod& method, Real share);

/// How well methods agree.
struct Agreement {
    int comparisons = 0;          ///< of one block of one scene by two methods
    double largestT = 0;          ///< the largest |t| of all of them
    double mostT = 0;             ///< what it may be: Bonferroni's quantile for a family rate of 1e-6
    double variance = 0;          ///< mean of t²
    double expectedVariance = 0;  ///< of Student's t: ν/(ν − 2)
    double varianceBand = 0;      ///< 4 √(2/n)
    double largestMeanT = 0;      ///< of whole pictures' means, standard errors apart
    double largestError = 0;      ///< largest standard error of a picture's mean, as a share of it
    std::int64_t samples = 0;     ///< paths of all pictures
    std::int64_t badSamples = 0;  ///< how many contributions were no finite numbers
    std::string worst;            ///< where |t| is largest, or means are farthest apart

    /// Whether the blocks agree and scatter as they should, and the means are within 5 standard errors.
    bool agrees() const {
        return largestT <= mostT && std::abs(variance - expectedVariance) <= varianceBand && largestMeanT <= 5;
    }
};

/// Renders each scene by each method in independent batches and compares all pairs by the luminance of blocks. Each
/// pair has pictures of its own, so no two comparisons share a number. What light tracing cannot show, paths whose
/// first surface seen from the eye has delta lobes only, is taken away from the other method path by path.
/// @param batches  of each picture, at least 2
/// @param samples  paths a pixel of each batch, at least 1
/// @param threads  at least 1; the numbers don't depend on it
Agreement compareMethods(const std::vector<AgreementScene>& scenes, const std::vector<AgreementMethod>& methods,
                         int batches, std::int64_t samples, int threads);

}  // namespace caustic::test
