#include "furnace.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/random.h"
#include "material/directions.h"
#include "material/fresnel.h"
#include "sampling/warp.h"

namespace caustic {

std::string nameOf(DirectionChoice choice) {
    if (choice == DirectionChoice::VisibleNormals) return "visible normals";
    return choice == DirectionChoice::AllNormals ? "all normals" : "cosine";
}

Furnace::Furnace(const Metal& metal, Real alphaX, Real alphaY, Real cosO)
    : metal_(metal), facets_(alphaX, alphaY), wo_(std::sqrt(1 - cosO * cosO), 0, cosO) {}

Real Furnace::weight(DirectionChoice choice, const Vec2& u) const {
    if (choice == DirectionChoice::Cosine) {
        const Vec3 wi = cosineHemisphere(u);
        const Vec3 wm = (wo_ + wi).normalized();
        const Color f = fresnelConductor(std::min(wo_.dot(wm), Real(1)), metal_.eta, metal_.k) * facets_.D(wm) *
                        facets_.reflectionG(wo_, wi) / (4 * wo_.z() * wi.z());
        return f.y() * std::numbers::pi;
    }
    const bool visible = choice == DirectionChoice::VisibleNormals;
    const Vec3 wm = visible ? facets_.sampleVisible(wo_, u) : facets_.sampleAll(u);
    const Real facing = wo_.dot(wm);
    const Vec3 wi = reflected(wo_, wm);
    if (facing <= 0 || wi.z() <= 0) return 0;
    // D cancels: it is in f and in the density.
    const Real f = fresnelConductor(std::min(facing, Real(1)), metal_.eta, metal_.k).y() * facets_.reflectionG(wo_, wi);
    return visible ? f / facets_.G1(wo_) : f * facing / (wo_.z() * wm.z());
}

Real Furnace::estimate(DirectionChoice choice, int samples, std::uint64_t seed, std::uint64_t round) const {
    Random random(seed, {round});
    Real sum = 0;
    for (int i = 0; i < samples; ++i) {
        const Real x = random.uniform();
        sum += weight(choice, {x, random.uniform()});
    }
    return sum / samples;
}

}  // namespace caustic
