#include "support/bsdf_checks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "core/random.h"
#include "support/direction_chi_square.h"
#include "support/sphere_integral.h"

namespace caustic::test {

namespace {

// Most densities end at the plane of ng: it is x = 0, so that cells end there too. Lobes along ng are narrow in some
// models, and would be in the way at the cells' poles.
Frame cellsOf(const ShadingFrame& shading) {
    const Frame around = Frame::around(shading.ng);
    return {around.n, around.s, around.t};
}

// Values of Radiance become energy when what comes through is scaled back.
Real energyScale(const ShadingFrame& shading, const Vec3& wo, const Vec3& wi) {
    const Real side = shading.side(wo);
    return shading.side(wi) == side ? 1 : shading.eta(side) * shading.eta(side);
}

}  // namespace

double bsdfProbability(const Bsdf& bsdf, const ShadingFrame& shading, const Vec3& wo, int samples, std::uint64_t seed) {
    const DirectionSampling sampling = {[&](const Vec2& u, Real uLobe) -> std::optional<Vec3> {
                                            const auto sample = bsdf.sample(wo, u, uLobe, TransportMode::Radiance);
                                            if (!sample || sample->delta()) return std::nullopt;
                                            return sample->wi;
                                        },
                                        [&](const Vec3& wi) { return bsdf.pdfW(wo, wi); }};
    return directionProbability(sampling, samples, seed, cellsOf(shading));
}

Color albedo(const Bsdf& bsdf, const ShadingFrame& shading, const Vec3& wo, Real accuracy) {
    const Frame axes = cellsOf(shading);
    Color sum = Color::Zero();
    for (const BsdfSample& lobe : bsdf.deltaLobes(wo, TransportMode::Radiance))
        sum += lobe.f * energyScale(shading, wo, lobe.wi);
    // Where samples go, f may have a peak.
    std::vector<Vec2> crowd;
    for (int i = 0; i < 4096; ++i) {
        Random random(1, {static_cast<std::uint64_t>(i)});
        const Real x = random.uniform();
        const Real y = random.uniform();
        const auto sample = bsdf.sample(wo, {x, y}, random.uniform(), TransportMode::Radiance);
        if (sample && !sample->delta()) crowd.push_back(placeOnSphere(axes.toLocal(sample->wi)));
    }
    for (int channel = 0; channel < 3; ++channel) {
        const auto reflected = [&](const Vec3& local) {
            const Vec3 wi = axes.toWorld(local);
            return bsdf.f(wo, wi, TransportMode::Radiance)[channel] * bsdf.cosine(wi) * energyScale(shading, wo, wi);
        };
        sum[channel] += sphereIntegral(reflected, {}, accuracy / 32, crowd);
    }
    return sum;
}

Real largestWeight(const Bsdf& bsdf, const ShadingFrame& shading, const Vec3& wo, int samples, std::uint64_t seed) {
    Real largest = 0;
    for (int i = 0; i < samples; ++i) {
        Random random(seed, {static_cast<std::uint64_t>(i)});
        const Real x = random.uniform();
        const Real y = random.uniform();
        const auto sample = bsdf.sample(wo, {x, y}, random.uniform(), TransportMode::Radiance);
        if (!sample) continue;
        const Real cosine = sample->delta() ? 1 : bsdf.cosine(sample->wi);
        const Color weight = sample->f * cosine * energyScale(shading, wo, sample->wi) / sample->pdfW;
        largest = weight.allFinite() ? std::max(largest, weight.maxCoeff()) : std::numeric_limits<Real>::infinity();
    }
    return largest;
}

Real reciprocityError(const Bsdf& bsdf, const ShadingFrame& shading, const Vec3& a, const Vec3& b) {
    const auto perIndexSquared = [&](const Vec3& wo, const Vec3& wi) -> Color {
        const Real ior = shading.side(wo) > 0 ? shading.iorAbove : shading.iorBelow;
        return bsdf.f(wo, wi, TransportMode::Radiance) / (ior * ior);
    };
    const Color forth = perIndexSquared(a, b);
    const Color back = perIndexSquared(b, a);
    const Real largest = std::max(forth.maxCoeff(), back.maxCoeff());
    return largest > 0 ? (forth - back).abs().maxCoeff() / largest : 0;
}

}  // namespace caustic::test
