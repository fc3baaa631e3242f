#pragma once

#include <vector>

#include "figure/failures.h"

namespace caustic::test {

/// What a chart of failures promises, on other cases than its own: robust methods get all of at least a thousand cases
/// right, fragile ones are seen to break.
/// @param least  the share of the cases, at least, that each fragile method gets wrong
void expectOnlyFragileMethodsFail(const std::vector<FailureRow>& rows, double least);

}  // namespace caustic::test
