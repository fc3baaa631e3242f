#pragma once

#include <vector>

#include "integrator/pixel_estimate.h"
#include "scene/scene.h"

namespace caustic {

/// Says which pixels want further paths. None of the rules changes when the whole scene gets brighter.
class AdaptiveRule {
public:
    virtual ~AdaptiveRule() = default;

    /// How much each pixel wants paths, row by row from the top: at least 0; 0 for not any more; a pixel of a larger
    /// number comes first.
    /// @param soFar  each pixel with at least one batch
    virtual std::vector<Real> wanted(const PixelEstimates& soFar) const = 0;
};

/// The report's ①: pixels in which light takes different ways, by the hash of the path through each of the four
/// corners. They want paths for ever, those with the fewest first.
class HashRule final : public AdaptiveRule {
public:
    /// @param maxLength  segments of a path
    /// @param threads    at least 1; the rule doesn't depend on it
    /// @param counts     what is done in the scene is added
    HashRule(const Scene& scene, int maxLength, int threads, RayCounts& counts);

    std::vector<Real> wanted(const PixelEstimates& soFar) const override;

private:
    std::vector<bool> mixed_;
};

/// The report's ②: pixels at edges of the picture so far, and in its noise. A pixel is at an edge when the Laplacian is
/// larger than a threshold in any channel. Values v are compressed before to v/(v + m), m being the picture's mean:
/// from 0 for black to 1/2 for the mean and 1 for the brightest, however bright the scene is.
class EdgeRule final : public AdaptiveRule {
public:
    /// @param threshold  of the Laplacian of the compressed picture, greater than 0 and at most 4
    /// @throws InputError otherwise
    explicit EdgeRule(Real threshold);

    std::vector<Real> wanted(const PixelEstimates& soFar) const override;

private:
    Real threshold_;
};

/// The report's ③: pixels whose confidence interval is wider than a tolerance, a share of the pixel's value and the
/// picture's mean together. The widest come first. All pixels end equally good.
class IntervalRule final : public AdaptiveRule {
public:
    /// @param tolerance   half the interval's width over (value + mean), greater than 0
    /// @param deviations  how sure the interval is, as for PixelEstimate::halfWidth; greater than 0
    /// @throws InputError otherwise
    explicit IntervalRule(Real tolerance, Real deviations = 1.96);

    std::vector<Real> wanted(const PixelEstimates& soFar) const override;

private:
    Real tolerance_;
    Real deviations_;
};

/// Pixels in which a further batch takes most off the picture's squared error: the variance of a mean, V, over the
/// number of batches, n, since V − V n/(n + 1) = V/(n + 1). Paths then go as the noise's standard deviation, which
/// makes the squared error of the whole least. They want paths for ever. Source: Neyman 1934, On the Two Different
/// Aspects of the Representative Method, V.
class GainRule final : public AdaptiveRule {
public:
    std::vector<Real> wanted(const PixelEstimates& soFar) const override;
};

}  // namespace caustic
