#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "math/vector.h"
#include "sampling/discrete_distribution.h"

namespace caustic {

/// Chooses a cell of a grid in proportion to its weight: first a row, by the sum of its weights (the marginal
/// distribution), then a column of that row (the conditional one). So two numbers choose, one for each axis, and evenly
/// spread pairs stay evenly spread. Source: PBR, 4th ed., A.5.
class GridDistribution {
public:
    /// A cell, and two numbers in [0, 1) that are uniform and don't depend on which one it is.
    struct Choice {
        std::size_t column;
        std::size_t row;
        Vec2 rest;
    };

    /// @param weights  row by row; as DiscreteDistribution takes them
    /// @param columns  of a row, at least 1; divides the number of weights
    /// @throws InputError otherwise
    GridDistribution(std::span<const Real> weights, std::size_t columns);

    /// Chooses a cell; never one whose weight is 0.
    /// @param u  two uniform numbers in [0, 1)
    Choice choose(const Vec2& u) const;

    /// How likely a cell is to be chosen.
    Real probability(std::size_t column, std::size_t row) const;

    /// Sum of all weights, in their unit.
    Real sum() const { return rows_->sum(); }

private:
    std::vector<std::optional<DiscreteDistribution>> columns_;  // of each row; none where all its weights are 0
    std::optional<DiscreteDistribution> rows_;                  // always there: made of the sums of the rows
};

}  // namespace caustic
