#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "math/real.h"

namespace caustic {

/// Chooses one of several things in proportion to their weights: lights by power, triangles and cells by area. Weights
/// may be as large or small as numbers get; one that rounding makes nothing beside the sum of those before it is never
/// chosen, and its probability is 0.
class DiscreteDistribution {
public:
    /// Which one was chosen, and a number in [0, 1) that is uniform and doesn't depend on which one it is.
    struct Choice {
        std::size_t index;
        Real rest;
    };

    /// @param weights  at least one greater than 0; none negative, infinite or not a number; in any unit
    /// @throws InputError otherwise
    explicit DiscreteDistribution(std::span<const Real> weights);

    /// Chooses one.
    /// @param u  uniform in [0, 1)
    /// @return its index; never one whose probability is 0
    std::size_t index(Real u) const;

    /// Chooses one, and keeps what is left of the number: that one can be used again.
    /// @param u  uniform in [0, 1)
    Choice choose(Real u) const;

    /// How likely one is to be chosen.
    Real probability(std::size_t index) const { return (sums_[index + 1] - sums_[index]) / sums_.back(); }

    /// Sum of the weights, in their unit.
    Real sum() const { return sums_.back() * scale_; }

    /// How many there are.
    std::size_t size() const { return sums_.size() - 1; }

private:
    std::vector<Real> sums_;  // of the weights before each one, and of all; over scale
    Real scale_;              // a power of two, about the largest weight: the sum stays finite, and no bit is lost
};

}  // namespace caustic
