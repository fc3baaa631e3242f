#pragma once

#include <vector>

#include "math/real.h"

namespace caustic {

/// Picks one of several cells of a parameter domain in proportion to its area on the surface.
class AreaCells {
public:
    /// A cell, and a number in [0, 1) that is uniform and independent of which one it is.
    struct Pick {
        std::size_t cell;
        Real rest;
    };

    /// @param areas  at least one, none negative, in any unit
    /// @throws InputError when their sum is not greater than 0 and finite
    explicit AreaCells(const std::vector<Real>& areas);

    /// @param u  uniform in [0, 1)
    Pick pick(Real u) const;

    /// The probability of a cell; 0 for one without area.
    Real probability(std::size_t cell) const { return (sums_[cell + 1] - sums_[cell]) / sums_.back(); }

private:
    std::vector<Real> sums_;  // of the areas before each cell, and of all
};

}  // namespace caustic
