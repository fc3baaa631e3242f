#include "shape/area_cells.h"

#include <algorithm>
#include <cmath>

#include "core/check.h"

namespace caustic {

AreaCells::AreaCells(const std::vector<Real>& areas) : sums_(1, 0) {
    for (const Real area : areas) sums_.push_back(sums_.back() + area);
    checkPositive(sums_.back(), "surface's area");
}

AreaCells::Pick AreaCells::pick(Real u) const {
    const Real wanted = u * sums_.back();
    auto after = std::upper_bound(sums_.begin(), sums_.end(), wanted);
    // Rounding may reach the end of the last cell that has an area.
    if (after == sums_.end()) after = std::lower_bound(sums_.begin(), sums_.end(), sums_.back());
    const auto cell = static_cast<std::size_t>(after - sums_.begin()) - 1;
    const Real rest = (wanted - sums_[cell]) / (sums_[cell + 1] - sums_[cell]);
    return {cell, std::min(rest, std::nextafter(Real(1), Real(0)))};
}

}  // namespace caustic
