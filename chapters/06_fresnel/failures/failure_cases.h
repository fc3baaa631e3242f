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
    bool robust = false;  ///< whether it is the course's own, which must not fail
};

/// All methods on all kinds of cases, each case made at random.
/// @param trials  of each kind
std::vector<FailureRow> failureRows(std::int64_t trials, std::uint64_t seed);

}  // namespace caustic
