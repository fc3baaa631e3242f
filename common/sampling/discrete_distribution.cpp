#include "sampling/discrete_distribution.h"

#include <algorithm>
#include <cmath>

#include "core/check.h"

namespace caustic {

namespace {

Real scaleOf(std::span<const Real> weights) {
    Real largest = 0;
    for (const Real weight : weights) {
        checkFinite(weight, "weight");
        checkArgument(weight >= 0, "weight", formatReal(weight), "must be at least 0");
        largest = std::max(largest, weight);
    }
    checkPositive(largest, "largest weight");
    return std::ldexp(Real(1), std::ilogb(largest));
}

}  // namespace

DiscreteDistribution::DiscreteDistribution(std::span<const Real> weights) : scale_(scaleOf(weights)) {
    sums_.reserve(weights.size() + 1);
    sums_.push_back(0);
    for (const Real weight : weights) sums_.push_back(sums_.back() + weight / scale_);
}

std::size_t DiscreteDistribution::index(Real u) const {
    const Real wanted = u * sums_.back();
    auto after = std::upper_bound(sums_.begin(), sums_.end(), wanted);
    // Rounding may reach the end of the last one that has a weight.
    if (after == sums_.end()) after = std::lower_bound(sums_.begin(), sums_.end(), sums_.back());
    return static_cast<std::size_t>(after - sums_.begin()) - 1;
}

DiscreteDistribution::Choice DiscreteDistribution::choose(Real u) const {
    const std::size_t at = index(u);
    const Real rest = (u * sums_.back() - sums_[at]) / (sums_[at + 1] - sums_[at]);
    return {at, std::clamp(rest, Real(0), std::nextafter(Real(1), Real(0)))};
}

}  // namespace caustic
