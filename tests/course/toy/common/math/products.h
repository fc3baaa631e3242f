#pragma once

#include <vector>

namespace caustic {

/// The sum of value times weight; both lists are of one length.
double weightedTotal(std::vector<double> values, const std::vector<double>& weights);

}  // namespace caustic
