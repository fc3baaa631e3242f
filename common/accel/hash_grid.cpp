#include "accel/hash_grid.h"

#include <bit>
#include <string>

#include "core/check.h"

namespace caustic {

HashGrid::HashGrid(std::span<const Vec3> points, Real cellSize)
    : perCell_(1 / cellSize),
      mask_(std::bit_ceil(static_cast<std::uint32_t>(std::max<std::size_t>(points.size(), 1))) - 1) {
    checkPositive(cellSize, "grid's cell size");
    checkArgument(std::isfinite(perCell_), "grid's cell size", std::to_string(cellSize), "is too small");
    checkArgument(points.size() < (std::size_t{1} << 31), "grid", std::to_string(points.size()), "has too many points");
    // Counting sort by slot: how many points each has, where they begin, and each point to its place.
    std::vector<std::uint32_t> slots(points.size());
    first_.assign(std::size_t{mask_} + 2, 0);
    for (std::size_t i = 0; i < points.size(); ++i) {
        checkArgument(points[i].allFinite(), "grid's point", std::to_string(i), "isn't finite");
        slots[i] = slotOf(cellOf(points[i]));
        ++first_[slots[i] + 1];
    }
    for (std::size_t slot = 1; slot < first_.size(); ++slot) first_[slot] += first_[slot - 1];
    points_.resize(points.size());
    order_.resize(points.size());
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const std::uint32_t place = next[slots[i]]++;
        points_[place] = points[i];
        order_[place] = static_cast<std::uint32_t>(i);
    }
}

}  // namespace caustic
