#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "sampling/emission_sampler.h"
#include "support/chi_square.h"

namespace caustic {
namespace {

constexpr double falseAlarm = 1e-6;
constexpr std::uint32_t columns = 9;
constexpr std::uint32_t rows = 14;

std::vector<Vec2> points(CellPlace place, std::int64_t round, Dimension dimension, std::uint64_t seed = 3) {
    const EmissionSampler sampler(seed, columns, rows, place);
    std::vector<Vec2> all;
    for (std::uint32_t cell = 0; cell < columns * rows; ++cell)
        all.push_back(
            sampler.pointOf(cell, {2, {0, 0}, round * columns * rows + (cell * 5) % (columns * rows)}, dimension));
    return all;
}

// Cell row · columns + column holds its point, wherever in it; in the plain grid that is its middle.
TEST(EmissionSampler, PutsEachPointIntoItsCell) {
    for (const CellPlace place : {CellPlace::Centre, CellPlace::Jittered, CellPlace::Offset}) {
        for (std::int64_t round = 0; round < 20; ++round) {
            const std::vector<Vec2> all = points(place, round, Dimension::emissionDirection());
            for (std::uint32_t cell = 0; cell < all.size(); ++cell) {
                const Vec2& u = all[cell];
                ASSERT_TRUE(u.minCoeff() >= 0 && u.maxCoeff() < 1);
                ASSERT_EQ(static_cast<std::uint32_t>(u.x() * columns), cell % columns) << "Which way do columns go?";
                ASSERT_EQ(static_cast<std::uint32_t>(u.y() * rows), cell / columns);
                if (place != CellPlace::Centre) continue;
                ASSERT_NEAR(u.x() * columns - cell % columns, 0.5, 1e-12);
                ASSERT_NEAR(u.y() * rows - cell / columns, 0.5, 1e-12);
            }
        }
    }
    // Of these paths' pairs, x of the first and y of the second are within 2⁻²⁹ of 1.
    const Dimension dimension = Dimension::emissionPoint();
    constexpr std::int64_t most = std::int64_t{1} << 31;
    for (const std::int64_t index : {39520239, 35318693}) {
        const PathName path = {2, {0, 0}, index};
        const Vec2 u = EmissionSampler(3, columns, rows, CellPlace::Jittered).pointOf(4 * columns + 5, path, dimension);
        EXPECT_EQ(static_cast<std::uint32_t>(u.x() * columns), 5U) << "Does a number just below 1 stay in its cell?";
        EXPECT_EQ(static_cast<std::uint32_t>(u.y() * rows), 4U) << "Does a number just below 1 stay in its cell?";
        for (const CellPlace place : {CellPlace::Jittered, CellPlace::Offset}) {
            const Vec2 last = EmissionSampler(3, most, 1, place).pointOf(most - 1, path, dimension);
            const Vec2 lowest = EmissionSampler(3, 1, most, place).pointOf(most - 1, path, dimension);
            EXPECT_LT(std::max(last.maxCoeff(), lowest.maxCoeff()), 1) << "May a sum round up to 1?";
        }
    }
}

// Over many rounds a jittered point, and an offset one, is anywhere in its cell, with the same density.
TEST(EmissionSampler, FillsItsCells) {
    for (const CellPlace place : {CellPlace::Jittered, CellPlace::Offset}) {
        std::vector<double> counts(36, 0);
        constexpr int rounds = 400;
        for (std::int64_t round = 0; round < rounds; ++round) {
            for (const Vec2& u : points(place, round, Dimension::emissionPoint())) {
                const Vec2 within(u.x() * columns - std::floor(u.x() * columns),
                                  u.y() * rows - std::floor(u.y() * rows));
                ++counts[6 * static_cast<std::size_t>(6 * within.x()) + static_cast<std::size_t>(6 * within.y())];
            }
        }
        const std::vector<double> expected(36, rounds * columns * rows / 36.0);
        EXPECT_GT(test::chiSquareProbability(counts, expected), falseAlarm)
            << "Are both coordinates moved within their cell, each by a number of its own?";
    }

    // With offsets: also within the place that the order leaves, 1/rows of the cell in x and 1/columns in y.
    std::vector<double> counts(36, 0);
    constexpr int rounds = 400;
    for (std::int64_t round = 0; round < rounds; ++round) {
        for (const Vec2& u : points(CellPlace::Offset, round, Dimension::emissionPoint())) {
            const Vec2 places = u * columns * rows;
            const Vec2 within(places.x() - std::floor(places.x()), places.y() - std::floor(places.y()));
            ++counts[6 * static_cast<std::size_t>(6 * within.x()) + static_cast<std::size_t>(6 * within.y())];
        }
    }
    EXPECT_GT(test::chiSquareProbability(counts, std::vector<double>(36, rounds * columns * rows / 36.0)), falseAlarm)
        << "Within the place that its order gives it, is a point moved by two numbers?";
}

// Chiu, Shirley, Wang 1994: with offsets, each coordinate alone has one point in each of columns · rows intervals.
TEST(EmissionSampler, OffsetsSpreadEachCoordinate) {
    for (std::int64_t round = 0; round < 10; ++round) {
        std::set<std::uint32_t> across;
        std::set<std::uint32_t> along;
        for (const Vec2& u : points(CellPlace::Offset, round, Dimension::emissionDirection())) {
            across.insert(static_cast<std::uint32_t>(u.x() * columns * rows));
            along.insert(static_cast<std::uint32_t>(u.y() * columns * rows));
        }
        EXPECT_EQ(across.size(), columns * rows) << "Do a column's points lie side by side in x?";
        EXPECT_EQ(along.size(), columns * rows) << "And a row's in y?";
    }
}

// In which order they lie is another one for each column, each row, each round and each pair.
TEST(EmissionSampler, OffsetsHaveOrdersOfTheirOwn) {
    std::set<std::vector<std::uint32_t>> orders;
    std::size_t lines = 0;
    for (std::int64_t round = 0; round < 5; ++round) {
        for (const Dimension dimension : {Dimension::emissionPoint(), Dimension::emissionDirection()}) {
            const std::vector<Vec2> all = points(CellPlace::Offset, round, dimension);
            for (std::uint32_t column = 0; column < columns; ++column, ++lines) {
                std::vector<std::uint32_t> order;
                for (std::uint32_t row = 0; row < rows; ++row)
                    order.push_back(static_cast<std::uint32_t>(all[row * columns + column].x() * columns * rows) %
                                    rows);
                orders.insert(order);
            }
        }
    }
    EXPECT_EQ(orders.size(), lines) << "The same order in all columns is a pattern again.";

    // In a square grid, columns and rows have orders of the same length: none is that of another one.
    constexpr std::uint32_t side = 13;
    const EmissionSampler square(8, side, side, CellPlace::Offset);
    orders.clear();
    lines = 0;
    for (std::int64_t round = 0; round < 3; ++round) {
        for (const Dimension dimension : {Dimension::emissionPoint(), Dimension::emissionDirection()}) {
            for (std::uint32_t line = 0; line < side; ++line, lines += 2) {
                std::vector<std::uint32_t> ofColumn;
                std::vector<std::uint32_t> ofRow;
                for (std::uint32_t i = 0; i < side; ++i) {
                    const PathName path = {2, {0, 0}, round * side * side + i};
                    const Real x = square.pointOf(i * side + line, path, dimension).x();
                    const Real y = square.pointOf(line * side + i, path, dimension).y();
                    ofColumn.push_back(static_cast<std::uint32_t>(x * side * side) % side);
                    ofRow.push_back(static_cast<std::uint32_t>(y * side * side) % side);
                }
                orders.insert(ofColumn);
                orders.insert(ofRow);
            }
        }
    }
    EXPECT_EQ(orders.size(), lines) << "Has each row an order of its own, too, which no column has?";
}

}  // namespace
}  // namespace caustic
