#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <memory>
#include <numbers>
#include <set>
#include <vector>

#include "camera/box_filter.h"
#include "camera/film.h"
#include "camera/pinhole_camera.h"
#include "camera/tent_filter.h"
#include "core/error.h"
#include "core/random.h"
#include "image/tone_mapping.h"
#include "sampling/independent_sampler.h"
#include "sampling/permutation.h"
#include "sampling/stratified_sampler.h"
#include "sampling/warp.h"
#include "support/chi_square.h"
#include "support/direction_chi_square.h"

namespace caustic {
namespace {

constexpr Real pi = std::numbers::pi;
constexpr double falseAlarm = 1e-6;
constexpr int samples = 200'000;

std::size_t slot(Real value, std::size_t slots) {
    return std::min(static_cast<std::size_t>(value * static_cast<Real>(slots)), slots - 1);
}

TEST(Sampler, TheSameNameGivesTheSameNumbers) {
    const IndependentSampler independent(7);
    const StratifiedSampler stratified(7, 3);
    const Sampler* const samplers[] = {&independent, &stratified};
    for (const Sampler* const sampler : samplers) {
        const PathNumbers path = sampler->start(0, {3, 5}, 11);
        const Dimension light = Dimension::vertex(2, VertexUse::LightPoint);
        const Vec2 first = path.pair(light);
        EXPECT_EQ(path.number(Dimension::vertex(2, VertexUse::Lobe)),
                  sampler->start(0, {3, 5}, 11).number(Dimension::vertex(2, VertexUse::Lobe)));
        EXPECT_EQ(sampler->start(0, {3, 5}, 11).pair(light), first);
        EXPECT_NE(sampler->start(0, {3, 5}, 12).pair(light), first);
        EXPECT_NE(sampler->start(0, {5, 3}, 11).pair(light), first);
        EXPECT_NE(sampler->start(1, {3, 5}, 11).pair(light), first);
        EXPECT_NE(path.branch(0).pair(light), first);
        EXPECT_NE(path.branch(0).pair(light), path.branch(1).pair(light));
        EXPECT_NE(path.pair(Dimension::film()), first);
    }
}

// Numbers and pairs, over pixels, indices and dimensions: each is uniform.
TEST(Sampler, NumbersAreUniform) {
    const IndependentSampler independent(1);
    const StratifiedSampler stratified(1, 5);
    const Sampler* const samplers[] = {&independent, &stratified};
    for (const Sampler* const sampler : samplers) {
        std::vector<double> pairs(100);
        std::vector<double> numbers(100);
        for (int i = 0; i < samples; ++i) {
            // 7 of each pixel's paths: no whole round of strata, so that the shuffle has to be fair.
            const PathNumbers path = sampler->start(0, {i / 7 % 300, i / 2100}, i % 7).branch(2);
            const Vec2 u = path.pair(Dimension::vertex(i % 3, VertexUse::Direction));
            const Real v = path.number(Dimension::vertex(i % 3, VertexUse::Roulette));
            ASSERT_TRUE(u.minCoeff() >= 0 && u.maxCoeff() < 1 && v >= 0 && v < 1);
            pairs[10 * slot(u.x(), 10) + slot(u.y(), 10)] += 1;
            numbers[slot(v, 100)] += 1;
        }
        const std::vector<double> expected(100, samples / 100.0);
        EXPECT_GT(test::chiSquareProbability(pairs, expected), falseAlarm);
        EXPECT_GT(test::chiSquareProbability(numbers, expected), falseAlarm);
    }
}

TEST(StratifiedSampler, EveryCellGetsOneOfEachRound) {
    for (const int side : {1, 2, 3, 8}) {
        const StratifiedSampler sampler(3, side);
        const int cells = side * side;
        for (int round = 0; round < 4; ++round) {
            std::set<std::size_t> pairs;
            std::set<std::size_t> numbers;
            for (int i = 0; i < cells; ++i) {
                const PathNumbers path = sampler.start(0, {1, 2}, round * cells + i);
                const Vec2 u = path.pair(Dimension::film());
                pairs.insert(slot(u.x(), static_cast<std::size_t>(side)) * static_cast<std::size_t>(side) +
                             slot(u.y(), static_cast<std::size_t>(side)));
                numbers.insert(slot(path.number(Dimension::lens()), static_cast<std::size_t>(cells)));
            }
            EXPECT_EQ(pairs.size(), static_cast<std::size_t>(cells));
            EXPECT_EQ(numbers.size(), static_cast<std::size_t>(cells));
        }
    }
}

// The parts of all paths of a pixel are paths of one long list: 4 paths of 9 parts fill a 6 × 6 grid.
TEST(StratifiedSampler, PartsOfPathsAreStratifiedTogether) {
    const StratifiedSampler sampler(3, 6);
    std::set<std::size_t> cells;
    for (int path = 0; path < 4; ++path) {
        for (int part = 0; part < 9; ++part) {
            const Vec2 u = sampler.start(0, {0, 0}, path).part(part, 9).pair(Dimension::film());
            cells.insert(6 * slot(u.x(), 6) + slot(u.y(), 6));
        }
    }
    EXPECT_EQ(cells.size(), 36U);
}

TEST(Permutation, IsOneToOne) {
    for (const std::uint32_t count : {1U, 2U, 7U, 64U, 100U}) {
        for (const std::uint32_t key : {0U, 1U, 0xdeadbeefU}) {
            std::set<std::uint32_t> images;
            for (std::uint32_t i = 0; i < count; ++i) images.insert(permuted(i, count, key));
            EXPECT_EQ(images.size(), count);
            EXPECT_LT(*images.rbegin(), count);
        }
    }
}

// The test's power: what claims 3 % more in one octant than it samples is rejected.
TEST(Warp, TestRejectsThreePercentInOneOctant) {
    const test::DirectionSampling wrong = {
        [](const Vec2& u, Real) { return uniformSphere(u); },
        [](const Vec3& d) { return (d.minCoeff() > 0 ? 1.03 : 1 - 0.03 / 7) / (4 * pi); }};
    EXPECT_LT(test::directionProbability(wrong, 20 * samples, 5), falseAlarm);
}

TEST(Warp, ConcentricDiscKeepsItsCentre) { EXPECT_EQ(concentricDisc({0.5, 0.5}), Vec2(0, 0)); }

// Densities: integral 1 by the midpoint rule; samples fall where the density says.
TEST(PixelFilter, SamplesHaveTheDensity) {
    const BoxFilter box;
    const TentFilter tent;
    const PixelFilter* const filters[] = {&box, &tent};
    for (const PixelFilter* const filter : filters) {
        constexpr std::size_t side = 16;
        const Real r = filter->radius();
        std::vector<double> expected;
        for (std::size_t i = 0; i < side * side; ++i) {
            double sum = 0;
            for (std::size_t k = 0; k < 64; ++k) {
                const Real x = (Real(i % side) + (Real(k % 8) + 0.5) / 8) / side;
                const Real y = (Real(i / side) + (Real(k / 8) + 0.5) / 8) / side;
                sum += filter->density({r * (2 * x - 1), r * (2 * y - 1)}) * 4 * r * r / (64 * side * side);
            }
            expected.push_back(samples * sum);
        }
        std::vector<double> observed(side * side);
        for (int i = 0; i < samples; ++i) {
            Random random(3, {static_cast<std::uint64_t>(i)});
            const Real x = random.uniform();
            const Vec2 offset = filter->sample({x, random.uniform()});
            observed[slot((offset.x() / r + 1) / 2, side) + side * slot((offset.y() / r + 1) / 2, side)] += 1;
        }
        EXPECT_GT(test::chiSquareProbability(observed, expected), falseAlarm);
    }
}

PinholeCamera exampleCamera() { return {{1, 2, 3}, {0, 0.5, -1}, Vec3::UnitY(), 0.7, 60, 40}; }

// From film to ray to a point on it and back to the film.
TEST(PinholeCamera, SeesAPointWhereItsRayStarts) {
    const PinholeCamera camera = exampleCamera();
    for (std::uint64_t i = 0; i < 1000; ++i) {
        Random random(4, {i});
        const Real x = random.uniform(0, 60);
        const Vec2 film(x, random.uniform(0, 40));
        const Ray ray = camera.sampleRay(film, {0.5, 0.5});
        EXPECT_NEAR(ray.direction.norm(), 1, 1e-14);
        const Real distance = random.uniform(0.1, 10);
        const auto seen = camera.sampleImportance(ray.at(distance), {0.5, 0.5});
        ASSERT_TRUE(seen);
        EXPECT_LE((seen->film - film).norm(), 1e-10);
        EXPECT_NEAR(seen->distance, distance, 1e-12);
        EXPECT_LE((seen->wi + ray.direction).norm(), 1e-12);
    }
    EXPECT_FALSE(camera.sampleImportance({2, 3.5, 7}, {0.5, 0.5})) << "behind the camera";
    EXPECT_FALSE(camera.sampleImportance({1, 2, 3}, {0.5, 0.5})) << "the pinhole itself";
}

// Both densities against a finite difference: a small square of film sees the solid angle du × dv of its rays.
TEST(PinholeCamera, ImportanceAndDensityAreTheFilmsSolidAngle) {
    const PinholeCamera camera = exampleCamera();
    const Real h = 1e-4;
    for (const Vec2& film : {Vec2(30, 20), Vec2(1, 2), Vec2(55, 31)}) {
        const Vec3 centre = camera.sampleRay(film, Vec2::Zero()).direction;
        const Vec3 du = (camera.sampleRay(film + Vec2(h, 0), Vec2::Zero()).direction -
                         camera.sampleRay(film - Vec2(h, 0), Vec2::Zero()).direction) /
                        (2 * h);
        const Vec3 dv = (camera.sampleRay(film + Vec2(0, h), Vec2::Zero()).direction -
                         camera.sampleRay(film - Vec2(0, h), Vec2::Zero()).direction) /
                        (2 * h);
        const Real solidAngle = std::abs(centre.dot(du.cross(dv)));  // of a pixel
        const auto seen = camera.sampleImportance(camera.sampleRay(film, Vec2::Zero()).at(2), Vec2::Zero());
        EXPECT_NEAR(seen->We * seen->cosine * solidAngle, 1, 1e-6);
        EXPECT_NEAR(camera.pdf(camera.sampleRay(film, Vec2::Zero())).pdfW * solidAngle * 60 * 40, 1, 1e-6);
    }
    EXPECT_EQ(camera.pdf({{1, 2, 3}, {0, 0, 1}}).pdfW, 0) << "away from the film";
}

TEST(Film, ShowsTheMeanOfAPixelsSamples) {
    Film film(3, 2);
    film.add({1, 0}, 0, Color(1, 2, 3));
    film.add({1, 0}, 1, Color(3, 2, 1));
    film.add({2, 1}, 0, Color(5, 5, 5));
    EXPECT_TRUE((film.value({1, 0}) == Color(2, 2, 2)).all());
    EXPECT_TRUE((film.value({2, 1}) == Color(5, 5, 5)).all());
    EXPECT_TRUE((film.value({0, 0}) == Color::Zero()).all());
    EXPECT_EQ(film.samples({1, 0}), 2);
    EXPECT_NEAR(film.image().at(1, 0).x(), 2, 1e-7);
}

TEST(Film, LeavesOutAndReportsWhatIsNoNumber) {
    Film film(2, 2);
    film.add({0, 1}, 4, Color(1, std::nan(""), 1));
    film.add({0, 1}, 5, Color(1, 1, INFINITY));
    film.add({0, 1}, 6, Color(1, 1, 1));
    film.splat({0.5, 0.5}, Color(INFINITY, 0, 0), BoxFilter());
    EXPECT_EQ(film.badSamples(), 3);
    EXPECT_EQ(film.firstBad()->pixel, (Pixel{0, 1}));
    EXPECT_EQ(film.firstBad()->index, 4);
    EXPECT_TRUE((film.value({0, 1}) == Color::Ones()).all());
    EXPECT_TRUE((film.value({0, 0}) == Color::Zero()).all());
}

// A filter's densities at the pixels' centres sum to 1 away from the border, so no light of a splat is lost or made.
TEST(Film, SplatsKeepTheirEnergy) {
    const TentFilter tent;
    const BoxFilter box;
    const PixelFilter* const filters[] = {&tent, &box};
    for (const PixelFilter* const filter : filters) {
        Film film(8, 8);
        for (std::uint64_t i = 0; i < 100; ++i) {
            Random random(5, {i});
            const Real x = random.uniform(2, 6);
            film.splat({x, random.uniform(2, 6)}, Color::Constant(0.5), *filter);
        }
        film.countSplatPaths(200);
        Color sum = Color::Zero();
        for (int i = 0; i < 64; ++i) sum += film.value({i % 8, i / 8});
        EXPECT_NEAR(sum.x(), 0.25, 1e-12);
    }
}

TEST(ToneMapping, WhiteIsOneAndDarkStays) {
    EXPECT_NEAR(luminance(toneMapped(Color::Constant(4), 1, 4)), 1, 1e-14);
    EXPECT_NEAR(luminance(toneMapped(Color::Constant(2), 2, 4)), 1, 1e-14);
    EXPECT_NEAR(toneMapped(Color(1e-6, 2e-6, 0), 1, 4).y() / 2e-6, 1, 1e-5);
    Real last = 0;
    for (Real y = 0.01; y < 10; y += 0.01) {
        const Color mapped = toneMapped(Color(y, y / 2, y / 4), 1, 4);
        EXPECT_GT(luminance(mapped), last) << "brighter stays brighter";
        EXPECT_NEAR(mapped.x() / mapped.z(), 4, 1e-12) << "hue stays";
        last = luminance(mapped);
    }
    const Image image(2, 1, Color::Constant(2));
    EXPECT_NEAR(toneMapped(image, 1, 2).at(1, 0).x(), 1, 1e-6);
    EXPECT_THROW(toneMapped(image, 0, 1), InputError);
    EXPECT_THROW(toneMapped(image, 1, -1), InputError);
}

}  // namespace
}  // namespace caustic
