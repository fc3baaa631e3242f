#pragma once

#include <vector>

namespace caustic::test {

/// Probability that counts drawn with these expectations differ from them at least as much as `observed` does:
/// Pearson's chi-square test. Reject below 1e-6.
///
/// Cells with an expectation below 5 are pooled (Cochran's rule); a count where nothing is expected has probability 0.
/// The expectations must sum to the number of draws.
double chiSquareProbability(const std::vector<double>& observed, const std::vector<double>& expected);

}  // namespace caustic::test
