#pragma once

#include <vector>

namespace caustic {

/// The sum of all values; 0 when there are none.
double total(const std::vector<double>& values);

/// The largest of at least one value.
double largest(const std::vector<double>& values);

/// The mean of at least one value.
double mean(const std::vector<double>& values);

}  // namespace caustic
