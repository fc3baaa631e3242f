#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "core/random.h"
#include "integrator/photon_volume.h"
#include "medium/henyey_greenstein.h"
#include "medium/homogeneous_medium.h"
#include "support/in_cube.h"

namespace caustic {
namespace {

constexpr Real pi = std::numbers::pi;

std::vector<Photon> photonsWithin(Real scale, int count, std::uint64_t seed) {
    Random random(seed, {});
    std::vector<Photon> photons;
    for (int i = 0; i < count; ++i) {
        Photon photon;
        photon.point = scale * test::inCube(random);
        photon.wi = test::inCube(random).normalized();
        photon.power = {random.uniform(0, 1), random.uniform(0, 2), random.uniform(0, 0.5)};
        photon.ng = Vec3::Zero();
        photon.length = 1 + static_cast<int>(random.below(4));
        photon.way =
            photon.length == 1 ? PhotonWay::Direct : (random.below(2) == 0 ? PhotonWay::Caustic : PhotonWay::Indirect);
        photons.push_back(photon);
    }
    return photons;
}

// From outside the cloud to a place in it, and on through it.
std::vector<MediumSpan> raysThrough(Real scale, const Medium& medium) {
    std::vector<MediumSpan> spans;
    for (const Vec3& from : {Vec3(2, 0.3, -0.4), Vec3(0.1, 0.2, -0.3), Vec3(-0.5, -1.5, 1)}) {
        const Vec3 direction = (Vec3(-0.2, 0.1, 0.2) - from).normalized();
        spans.push_back({{scale * from, direction}, scale * 2.2, &medium, {}, Color::Ones()});
    }
    return spans;
}

// Straight out of the lesson: every photon is asked.
Color bruteForce(const std::vector<Photon>& photons, const MediumSpan& span, const PhaseFunction& phase,
                 const Color& sigmaT, const BeamSettings& settings) {
    Color sum = Color::Zero();
    for (const Photon& photon : photons) {
        const Vec3 way = photon.point - span.ray.origin;
        const Real t = way.dot(span.ray.direction);
        const Real d = (way - t * span.ray.direction).norm();
        if (t <= 0 || t >= span.tEnd || d > settings.radius) continue;
        if (photon.length + settings.eyeSegments > settings.mostSegments) continue;
        if (photon.way == PhotonWay::Direct && !settings.direct) continue;
        const Real share = 1 - d * d / (settings.radius * settings.radius);
        const Real kernel = 3 * share * share / (pi * settings.radius * settings.radius);
        sum += photon.power * (-sigmaT * t).exp() * phase.p(-span.ray.direction, photon.wi) * kernel;
    }
    return sum;
}

void expectSum(Real scale, const Color& sigmaT, const std::shared_ptr<const PhaseFunction>& phase,
               const BeamSettings& settings, const std::string& question) {
    const HomogeneousMedium medium(0.4 * sigmaT, 0.6 * sigmaT, phase);
    const std::vector<Photon> photons = photonsWithin(scale, 3000, 7);
    const PhotonVolume volume(photons);
    for (const MediumSpan& span : raysThrough(scale, medium)) {
        const Color expected = bruteForce(photons, span, *phase, sigmaT, settings);
        EXPECT_GT(expected.minCoeff(), 0);
        EXPECT_LE((volume.radiance(span, settings) / expected - 1).abs().maxCoeff(), 1e-9) << question;
    }
}

const std::shared_ptr<const PhaseFunction> even = std::make_shared<HenyeyGreenstein>(0);

// Coloured extinction on the way from the photon to where the piece begins, and the kernel's share of each photon
// beside this piece; at scales of a millimetre and a kilometre.
TEST(PhotonVolume, DimsFromThePhotonToTheEye) {
    for (const Real scale : {1e-3, 1.0, 1e3})
        expectSum(scale, Color(0.4, 2, 1) / scale, even, {0.25 * scale, 10, 1, true},
                  "How far has light of each colour to go, and through what? By which kernel is it spread?");
}

// Forwards and backwards: wi leads to where the photon came from, wo to the eye.
TEST(PhotonVolume, TurnsLightByThePhaseFunction) {
    for (const Real g : {-0.6, 0.7})
        expectSum(1, Color::Constant(1e-12), std::make_shared<HenyeyGreenstein>(g), {0.25, 10, 1, true},
                  "Which of the two directions leads to the eye?");
}

// Photons have come some segments, the eye's path has some, and what is too long together doesn't count.
TEST(PhotonVolume, CountsSegmentsOfBothSides) {
    for (const int most : {3, 4, 5})
        expectSum(1, Color::Constant(1e-12), even, {0.3, most, 2, true},
                  "Segments of the photon and of the eye's path together, at most that many?");
}

// What is sampled otherwise must not be there twice.
TEST(PhotonVolume, LeavesDirectLightOut) {
    expectSum(1, Color::Constant(1e-12), even, {0.3, 10, 1, false},
              "Photons straight from a lamp, when direct light is sampled?");
}

}  // namespace
}  // namespace caustic
