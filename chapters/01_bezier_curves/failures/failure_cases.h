#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/random.h"

namespace caustic {

/// How many cases each generator makes.
inline constexpr int failureTrials = 2000;

/// A method against one kind of case.
struct FailureProbe {
    std::string method;
    std::string name;               ///< of the kind of case, with the tolerance beyond which the result is a failure
    bool (*fails)(Random& random);  ///< makes a case from the numbers, runs the method, judges the result
    bool robust;                    ///< whether the method must survive every case
};

/// All probes; those of the same kind stand together, and make the same cases from the same numbers.
std::vector<FailureProbe> failureProbes();

/// The failures of one probe in failureTrials cases. The same for any number of threads, and for every probe of the
/// same kind the same cases.
int countFailures(const FailureProbe& probe, std::uint64_t seed, int threads);

}  // namespace caustic
