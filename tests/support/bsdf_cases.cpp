#include "support/bsdf_cases.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "material/diffuse_bsdf.h"
#include "material/phong_bsdf.h"
#include "material/rough_conductor_bsdf.h"
#include "material/rough_dielectric_bsdf.h"
#include "sampling/warp.h"

namespace caustic::test {

namespace {

constexpr Real twoPi = 2 * std::numbers::pi;
constexpr Real cosines[] = {1, 0.8, 0.45, 0.15, -0.3, -0.9};
constexpr Real roughnesses[][2] = {{0.02, 0.02}, {0.1, 0.1}, {0.3, 0.3}, {1, 1}, {0.05, 0.3}, {0.6, 0.15}};

// With this cosine to ng.
Vec3 seenFrom(const ShadingFrame& shading, Real cosine, Random& random) {
    const Frame axes = Frame::around(shading.ng);
    const Real turn = random.uniform(0, twoPi);
    const Real r = std::sqrt(1 - cosine * cosine);
    return axes.toWorld({r * std::cos(turn), r * std::sin(turn), cosine});
}

template <typename Make>
void addPlaces(std::vector<BsdfCase>& all, const std::string& name, Real ior, const Make& make) {
    for (const bool smooth : {false, true}) {
        for (const Real cosine : cosines) {
            Random random(all.size(), {1});
            const ShadingFrame shading = anyPlace(random, smooth, ior);
            all.push_back({name + (smooth ? ", ns apart from ng" : "") + ", cosine " + std::to_string(cosine), shading,
                           seenFrom(shading, cosine, random), make(shading)});
        }
    }
}

std::string named(const Real (&alpha)[2]) { return std::to_string(alpha[0]) + " × " + std::to_string(alpha[1]); }

}  // namespace

ShadingFrame anyPlace(Random& random, bool smooth, Real ior) {
    ShadingFrame shading;
    const Real x = random.uniform();
    shading.ng = uniformSphere({x, random.uniform()});
    const Frame around = Frame::around(shading.ng);
    const Vec3 ns = smooth ? (std::cos(0.25) * around.n + std::sin(0.25) * around.s).eval() : shading.ng;
    const Frame tangents = Frame::around(ns);
    const Real turn = random.uniform(0, twoPi);
    const Vec3 s = std::cos(turn) * tangents.s + std::sin(turn) * tangents.t;
    shading.frame = {s, ns.cross(s), ns};
    shading.iorBelow = ior;
    return shading;
}

std::vector<BsdfCase> earlierBsdfCases() {
    std::vector<BsdfCase> all;
    addPlaces(all, "diffuse", 1,
              [](const ShadingFrame& at) { return std::make_shared<DiffuseBsdf>(at, Color(0.2, 0.5, 0.9)); });
    for (const Real exponent : {0.0, 1.0, 5.0, 20.0, 100.0}) {
        addPlaces(all, "Phong, exponent " + std::to_string(exponent), 1, [&](const ShadingFrame& at) {
            return std::make_shared<PhongBsdf>(at, Color(0.2, 0.3, 0.1), Color(0.5, 0.5, 0.8), exponent);
        });
    }
    return all;
}

std::vector<BsdfCase> roughConductorCases() {
    std::vector<BsdfCase> all;
    for (const auto& alpha : roughnesses) {
        for (const Metal& metal : {Metal::gold(), Metal::silver()}) {
            addPlaces(all, "conductor " + named(alpha), 1, [&](const ShadingFrame& at) {
                return std::make_shared<RoughConductorBsdf>(at, metal, Ggx(alpha[0], alpha[1]));
            });
        }
    }
    return all;
}

std::vector<BsdfCase> roughDielectricCases(Real ior) {
    std::vector<BsdfCase> all;
    for (const auto& alpha : roughnesses) {
        addPlaces(all, "dielectric " + std::to_string(ior) + ", " + named(alpha), ior, [&](const ShadingFrame& at) {
            return std::make_shared<RoughDielectricBsdf>(at, Ggx(alpha[0], alpha[1]));
        });
    }
    return all;
}

}  // namespace caustic::test
