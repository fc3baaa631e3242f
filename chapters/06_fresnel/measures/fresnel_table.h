#pragma once

#include <vector>

#include "material/fresnel.h"

namespace caustic {

/// Fresnel's equations looked up: even steps of the cosine, straight lines between them. What was done when roots were
/// dear.
class FresnelTable {
public:
    /// @param steps  at least 1
    FresnelTable(Real eta, int steps) : steps_(steps) {
        for (int i = 0; i <= steps; ++i) values_.push_back(fresnelDielectric(static_cast<Real>(i) / steps, eta));
        values_.push_back(values_.back());
    }

    /// @param cosO  in [0, 1]
    Real operator()(Real cosO) const {
        const Real place = cosO * steps_;
        const auto i = static_cast<std::size_t>(place);
        const Real rest = place - static_cast<Real>(i);
        return values_[i] + rest * (values_[i + 1] - values_[i]);
    }

private:
    int steps_;
    std::vector<Real> values_;
};

}  // namespace caustic
