#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace caustic {

/// One method on one kind of case: how often it was wrong.
struct FailureRow {
    std::string method;
    std::string name;  ///< of the case
    std::int64_t failures = 0;
    std::int64_t trials = 0;
    bool robust = false;  ///< whether it is said to get all of them right
};

/// All methods on all kinds of cases, each case made at random and known in closed form.
/// @param trials   of each kind, at least 1
/// @param threads  at least 1; the rows don't depend on it
std::vector<FailureRow> failureRows(std::int64_t trials, std::uint64_t seed, int threads);

}  // namespace caustic
