#include "support/chi_square.h"

#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>
#include <stdexcept>

namespace caustic::test {

double chiSquareProbability(const std::vector<double>& observed, const std::vector<double>& expected) {
    if (observed.size() != expected.size()) throw std::logic_error("chi-square: as many observed as expected cells");
    double observedSum = 0;
    double expectedSum = 0;
    double pooledObserved = 0;
    double pooledExpected = 0;
    double statistic = 0;
    int cells = 0;
    const auto addCell = [&](double seen, double mean) {
        statistic += (seen - mean) * (seen - mean) / mean;
        ++cells;
    };
    for (std::size_t i = 0; i < observed.size(); ++i) {
        observedSum += observed[i];
        expectedSum += expected[i];
        if (expected[i] == 0 && observed[i] > 0) return 0;
        if (expected[i] >= 5) {
            addCell(observed[i], expected[i]);
        } else {
            pooledObserved += observed[i];
            pooledExpected += expected[i];
        }
    }
    if (std::abs(observedSum - expectedSum) > 1e-6 * observedSum)
        throw std::logic_error("chi-square: the expectations must sum to the number of draws");
    if (pooledExpected >= 5) addCell(pooledObserved, pooledExpected);
    if (cells < 2) throw std::logic_error("chi-square: fewer than two cells");
    return cdf(complement(boost::math::chi_squared(cells - 1), statistic));
}

}  // namespace caustic::test
