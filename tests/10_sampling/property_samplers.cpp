#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <vector>

#include "core/error.h"
#include "core/random.h"
#include "sampling/emission_sampler.h"
#include "sampling/halton_sampler.h"
#include "sampling/sampler_names.h"
#include "support/chi_square.h"

namespace caustic {
namespace {

constexpr double falseAlarm = 1e-6;

// Every sampler: numbers and pairs are uniform over pixels, paths, dimensions, served or not.
TEST(Samplers, NumbersAreUniform) {
    const EmissionSampler emission(5, 7, 11, CellPlace::Offset);
    std::vector<std::unique_ptr<const Sampler>> all;
    for (const std::string& name : samplerNames()) all.push_back(makeSampler(name, 3, 50));
    std::vector<const Sampler*> samplers = {&emission};
    for (const auto& one : all) samplers.push_back(one.get());
    for (const Sampler* const sampler : samplers) {
        for (const int dimension : {0, 2, 9, 11, 27}) {
            std::vector<double> pairs(64, 0);
            std::vector<double> numbers(64, 0);
            constexpr int paths = 40'000;
            for (int i = 0; i < paths; ++i) {
                const PathNumbers path =
                    sampler->start(static_cast<std::uint64_t>(i % 3), {i / 5 % 90, i / 450}, i % 5);
                const Vec2 u = path.pair({dimension});
                const Real v = path.number({dimension + 5});
                ASSERT_TRUE(u.minCoeff() >= 0 && u.maxCoeff() < 1 && v >= 0 && v < 1);
                ++pairs[8 * static_cast<std::size_t>(8 * u.x()) + static_cast<std::size_t>(8 * u.y())];
                ++numbers[static_cast<std::size_t>(64 * v)];
            }
            const std::vector<double> expected(64, paths / 64.0);
            EXPECT_GT(test::chiSquareProbability(pairs, expected), falseAlarm) << "dimension " << dimension;
            EXPECT_GT(test::chiSquareProbability(numbers, expected), falseAlarm) << "dimension " << dimension;
        }
    }
}

// The first dimensions of one pixel's paths are Halton's: bases 2 and 3 together put one of 36 points into each box of
// 4 × 9; other pixels and seeds have other points.
TEST(HaltonSampler, SpreadsThePathsOfAPixel) {
    const HaltonSampler sampler(9);
    for (const std::int64_t start : {std::int64_t{0}, std::int64_t{36} * 17, std::int64_t{36} * 100'000'000}) {
        std::set<int> boxes;
        for (std::int64_t i = 0; i < 36; ++i) {
            const Vec2 u = sampler.start(0, {4, 2}, start + i).pair(Dimension::film());
            boxes.insert(9 * static_cast<int>(4 * u.x()) + static_cast<int>(9 * u.y()));
        }
        EXPECT_EQ(boxes.size(), 36U) << "from path " << start;
    }
    EXPECT_NE(sampler.start(0, {4, 2}, 1).pair(Dimension::film()), sampler.start(0, {2, 4}, 1).pair(Dimension::film()));
    EXPECT_NE(sampler.start(0, {4, 2}, 1).pair(Dimension::film()), sampler.start(1, {4, 2}, 1).pair(Dimension::film()));
    EXPECT_NE(sampler.start(0, {4, 2}, 1).pair(Dimension::film()),
              HaltonSampler(8).start(0, {4, 2}, 1).pair(Dimension::film()));
}

// Place and direction of a photon aren't tied to each other: with as many cells as photons each of 36 pairs of halves
// of the two occurs.
TEST(EmissionSampler, PlaceAndDirectionAreShuffledApart) {
    const EmissionSampler sampler(4, 30, 30, CellPlace::Centre);
    std::vector<double> counts(81, 0);
    constexpr int rounds = 40;
    for (std::int64_t i = 0; i < 900 * rounds; ++i) {
        const PathNumbers path = sampler.start(2, {0, 0}, i);
        const Vec2 place = path.pair(Dimension::emissionPoint());
        const Vec2 direction = path.pair(Dimension::emissionDirection());
        const auto third = [](const Vec2& u) {
            return 3 * static_cast<std::size_t>(3 * u.x()) + static_cast<std::size_t>(3 * u.y());
        };
        ++counts[9 * third(place) + third(direction)];
    }
    EXPECT_GT(test::chiSquareProbability(counts, std::vector<double>(81, 900 * rounds / 81.0)), falseAlarm);
}

TEST(Samplers, AreMadeByName) {
    for (const std::string& name : samplerNames()) EXPECT_NE(makeSampler(name, 1, 10), nullptr);
    for (const char* const name : {"", "Sobol", "random ", "latin"}) {
        try {
            makeSampler(name, 1, 10);
            ADD_FAILURE() << name;
        } catch (const InputError& error) {
            EXPECT_NE(std::string(error.what()).find("stratified"), std::string::npos) << error.what();
        }
    }
    EXPECT_THROW(makeSampler("random", 1, 0), InputError);
    EXPECT_THROW(makeSampler("stratified", 1, -3), InputError);
    EXPECT_THROW(makeSampler("stratified", 1, 4096LL * 4096 + 1), InputError);
    EXPECT_THROW(EmissionSampler(1, 0, 5, CellPlace::Centre), InputError);
    EXPECT_THROW(EmissionSampler(1, 5, -1, CellPlace::Centre), InputError);
    EXPECT_THROW(EmissionSampler(1, 1 << 20, 1 << 20, CellPlace::Centre), InputError);
}

}  // namespace
}  // namespace caustic
