#include <algorithm>
#include <cmath>
#include <numbers>

#include "figures.h"
#include "furnace.h"
#include "material/dielectric_bsdf.h"
#include "material/directions.h"
#include "material/fresnel.h"
#include "material/rough_conductor_material.h"
#include "material/rough_dielectric_bsdf.h"
#include "sampling/warp.h"

namespace caustic {

namespace {

// Each says whether the fragile method and the course's own are right.

bool isShare(Real value) { return value >= 0 && value <= 1; }

// The formulas as they stand in the books, without a look at what is under the root.
Real byTheBook(Real cosO, Real eta) {
    const Real cosI = std::sqrt(1 - (1 - cosO * cosO) / (eta * eta));
    const Real across = (cosO - eta * cosI) / (cosO + eta * cosI);
    const Real within = (eta * cosO - cosI) / (eta * cosO + cosI);
    return (across * across + within * within) / 2;
}

Real criticalCosine(Real eta) { return std::sqrt(1 - eta * eta); }

// From inside, a hair's breadth on either side of the critical angle: right is a share.
std::vector<bool> aroundCritical(Random& random) {
    const Real eta = random.uniform(0.3, 0.95);
    const Real cosO = criticalCosine(eta) * (1 + std::pow(10, random.uniform(-16, -6)) * (random.below(2) ? 1 : -1));
    return {isShare(byTheBook(cosO, eta)), isShare(fresnelDielectric(cosO, eta))};
}

// Just before it nearly all is reflected. Chapter 05's glass jumps there from its fixed share to all.
std::vector<bool> justBeforeCritical(Random& random) {
    const Real eta = random.uniform(0.3, 0.95);
    const Real cosO = criticalCosine(eta) * (1 + std::pow(10, random.uniform(-12, -6)));
    constexpr Real fixedShare = 0.04;
    return {std::abs(fixedShare - 1) < 0.05, std::abs(fresnelDielectric(cosO, eta) - 1) < 0.05};
}

// Index 1: nothing is there to see, at any angle. Schlick's formula still rises to 1 along the surface.
std::vector<bool> indexOne(Random& random) {
    const Real cosO = random.uniform(0, 1);
    return {schlick(cosO, 1) < 1e-6, fresnelDielectric(cosO, 1) < 1e-6};
}

// Nearly along a surface whose index is nearly 1: R = ((c − √(c² + 2d))/(c + √(c² + 2d)))², with d = η − 1. By the book
// 1 − sin² loses all digits. Right to a millionth.
std::vector<bool> grazing(Random& random) {
    const Real cosO = std::pow(10, random.uniform(-9, -5));
    const Real past = std::pow(10, random.uniform(-16, -10));
    const Real eta = 1 + past;
    const long double c = cosO;
    const long double d = static_cast<long double>(eta) - 1;
    const long double other = std::sqrt(c * c + d * (2 + d));
    const long double amplitude = (c - other) / (c + other);
    const Real truth = static_cast<Real>(amplitude * amplitude);
    return {std::abs(byTheBook(cosO, eta) - truth) < 1e-6, std::abs(fresnelDielectric(cosO, eta) - truth) < 1e-6};
}

// Facets ever flatter: the sampled direction's weight has to be the mirror's reflectance, to a percent. Fragile: no
// roughness is too small to be divided by.
std::vector<bool> flattening(Random& random) {
    const Real alpha = std::pow(10, random.uniform(-300, -2));
    const Real x = random.uniform();
    const Vec3 wo = cosineHemisphere({x, random.uniform(0, 0.9)});
    const Vec2 u(random.uniform(), random.uniform());
    const Metal gold = Metal::gold();
    const Real truth = fresnelConductor(wo.z(), gold.eta, gold.k).y();

    const Real steep = alpha * std::sqrt(u.x() / (1 - u.x()));
    const Real density = 1 / (std::numbers::pi * alpha * alpha * std::pow(1 + steep * steep / (alpha * alpha), 2));
    const Real fragile = truth * density / density;

    BsdfBuffer bsdf;
    RoughConductorMaterial(gold, alpha, alpha).build({}, {}, bsdf);
    const auto sample = bsdf.get()->sample(wo, u, 0, TransportMode::Radiance);
    const Real cosine = sample && !sample->delta() ? bsdf.get()->cosine(sample->wi) : 1;
    const Real robust = sample ? sample->f.y() * cosine / sample->pdfW : 0;
    return {std::abs(fragile - truth) < 0.01, std::abs(robust - truth) < 0.01 + (alpha > 1e-4 ? 0.05 : 0)};
}

// A sample that counts more than all the light there is makes a firefly.
std::vector<bool> fireflies(Random& random) {
    const Real alpha = random.uniform(0.05, 1);
    const Furnace furnace(Metal::silver(), alpha, alpha, random.uniform(0.05, 1));
    const Vec2 u(random.uniform(), random.uniform());
    return {furnace.weight(DirectionChoice::AllNormals, u) <= 1 + 1e-12,
            furnace.weight(DirectionChoice::VisibleNormals, u) <= 1 + 1e-12};
}

// Shading normals that face away from wo, on rough glass: a reflection must stay on wo's side of the real surface, and
// every number finite. Fragile: mirrors at the shading normal and looks no further.
std::vector<bool> facingAway(Random& random) {
    ShadingFrame shading;
    shading.iorBelow = 1.5;
    const Real tilt = random.uniform(0.2, 0.6);
    const Vec3 ns(std::sin(tilt), 0, std::cos(tilt));
    shading.frame = Frame::around(ns);
    const Real cosO = random.uniform(0.001, 0.3);
    const Vec3 wo(-std::sqrt(1 - cosO * cosO), 0, cosO);
    const Vec3 mirrored = reflected(wo, ns);

    const RoughDielectricBsdf glass(shading, Ggx(0.2, 0.2));
    const Real x = random.uniform();
    const Vec2 u(x, random.uniform());
    const auto sample = glass.sample(wo, u, random.uniform(), TransportMode::Importance);
    const bool right = !sample || (sample->f.allFinite() && sample->pdfW > 0 && std::isfinite(sample->pdfW) &&
                                   (sample->wi.z() < 0) == sample->transmits());
    return {mirrored.z() > 0, right};
}

}  // namespace

std::vector<FailureRow> failureRows(const FailureTrials& trials) {
    const TriedMethod exact = {"Fresnel's equations", true};
    return countFailures(
        {{"around the critical angle: a share of the light?", {{"by the book"}, exact}, aroundCritical},
         {"just before the critical angle: nearly all?", {{"fixed share"}, exact}, justBeforeCritical},
         {"index 1: nothing to see?", {{"Schlick"}, exact}, indexOne},
         {"grazing with an index near 1: right to 1e-6?", {{"by the book"}, exact}, grazing},
         {"roughness → 0: as bright as the mirror?", {{"no least roughness"}, {"smooth below 1e-4", true}}, flattening},
         {"rough silver: no sample above all light?", {{"all normals"}, {"visible normals", true}}, fireflies},
         {"normal faces away: light stays outside?",
          {{"side of the shading normal"}, {"both normals asked", true}},
          facingAway}},
        trials);
}

void chartFailures(FigureContext& context) { drawFailureBars(failureRows(FailureTrials::of(context, 2000)), context); }

}  // namespace caustic
