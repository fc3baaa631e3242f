#include "sampling/grid_distribution.h"

#include <algorithm>
#include <string>

#include "core/check.h"

namespace caustic {

GridDistribution::GridDistribution(std::span<const Real> weights, std::size_t columns) {
    checkArgument(columns >= 1 && weights.size() % columns == 0, "grid's columns", std::to_string(columns),
                  "must divide the number of weights");
    std::vector<Real> sums;
    for (std::size_t first = 0; first < weights.size(); first += columns) {
        const auto row = weights.subspan(first, columns);
        const bool black = std::all_of(row.begin(), row.end(), [](Real weight) { return weight == 0; });
        columns_.push_back(black ? std::nullopt : std::optional<DiscreteDistribution>(row));
        sums.push_back(black ? 0 : columns_.back()->sum());
    }
    rows_.emplace(sums);
}

GridDistribution::Choice GridDistribution::choose(const Vec2& u) const {
    const DiscreteDistribution::Choice row = rows_->choose(u.y());
    const DiscreteDistribution::Choice column = columns_[row.index]->choose(u.x());
    return {column.index, row.index, {column.rest, row.rest}};
}

Real GridDistribution::probability(std::size_t column, std::size_t row) const {
    return columns_[row] ? rows_->probability(row) * columns_[row]->probability(column) : 0;
}

}  // namespace caustic
