#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "accel/nearest_points.h"
#include "core/mixer.h"
#include "core/not_implemented.h"
#include "math/vector.h"

namespace caustic {

/// A grid of points without borders: which points lie within a radius.
///
/// Space is cut into cubes, and a hash says in which of a table's places the points of a cube are listed. Any place may
/// hold the points of several cubes; each point is found once all the same, and those outside all points' box are asked
/// for like any other. Cubes that are neighbours along x are neighbours in the table, so that a row of them is looked
/// through in one go. A point's place is where the grid keeps it, as in PointKdTree.
/// Source: Teschner et al. 2003, Optimized Spatial Hashing for Collision Detection of Deformable Objects.
class HashGrid {
public:
    /// @param cellSize  edge of the cubes, m, greater than 0; best twice the radius that most queries have
    /// @throws InputError when it isn't finite and greater than 0, a coordinate isn't finite, or there are 2³¹ points
    /// or
    ///         more
    HashGrid(std::span<const Vec3> points, Real cellSize);

    /// How many points there are.
    std::size_t size() const { return points_.size(); }
    /// By place: which point of the given list it is.
    std::span<const std::uint32_t> order() const { return order_; }
    /// By place: where it is.
    const Vec3& point(std::size_t place) const { return points_[place]; }

    /// Calls visit(const NearPoint&) for each point within a radius, the border included: once each, in an order that
    /// depends on the points and the query alone. Within a negative radius, and around what isn't finite, there is
    /// none.
    template <typename Visit>
    void within(const Vec3& query, Real radius, const Visit& visit) const;

private:
    using Cell = Eigen::Matrix<std::int64_t, 3, 1>;

    // A row of cubes: along x from `low`, along y and z it is there alone.
    struct Row {
        Cell low;
        std::int64_t highX;

        bool contains(const Cell& cell) const {
            return cell.y() == low.y() && cell.z() == low.z() && cell.x() >= low.x() && cell.x() <= highX;
        }
    };

    std::int64_t cellOf(Real coordinate) const {
        // Far out all cubes are one, so that there is an integer for each: distances decide anyway.
        return static_cast<std::int64_t>(std::floor(std::clamp(coordinate * perCell_, Real(-1e18), Real(1e18))));
    }
    Cell cellOf(const Vec3& point) const { return {cellOf(point.x()), cellOf(point.y()), cellOf(point.z())}; }
    std::uint32_t slotOf(const Cell& cell) const;

    template <typename Accept, typename Visit>
    void look(std::uint32_t from, std::uint32_t to, const Vec3& query, Real squared, const Accept& accept,
              const Visit& visit) const;

    Real perCell_;
    std::uint32_t mask_;                // slots − 1, a power of two
    std::vector<std::uint32_t> first_;  // by slot: place of its first point; one more for the end
    std::vector<Vec3> points_;
    std::vector<std::uint32_t> order_;
};

inline std::uint32_t HashGrid::slotOf(const Cell& cell) const {
    const auto y = static_cast<std::uint64_t>(cell.y());
    const auto z = static_cast<std::uint64_t>(cell.z());
    const std::uint64_t row = (y * goldenStep) ^ (z * 0xc2b2ae3d27d4eb4fULL);
    return static_cast<std::uint32_t>((row >> 32) + static_cast<std::uint64_t>(cell.x())) & mask_;
}

template <typename Accept, typename Visit>
void HashGrid::look(std::uint32_t from, std::uint32_t to, const Vec3& query, Real squared, const Accept& accept,
                    const Visit& visit) const {
    for (std::uint32_t place = from; place < to; ++place) {
        const Real distance = (points_[place] - query).squaredNorm();
        if (distance <= squared && accept(points_[place])) visit(NearPoint{place, distance});
    }
}

template <typename Visit>
void HashGrid::within(const Vec3& query, Real radius, const Visit& visit) const {
    //! [ex-09.2]
    if (points_.empty() || !(radius >= 0) || !query.allFinite()) return;
    const Real squared = radius * radius;
    // A point that rounding brings to the border must not lie in a cube behind it.
    const Vec3 reach = (Vec3::Constant(radius) + query.cwiseAbs()) * 0x1p-50 + Vec3::Constant(radius);
    const Cell low = cellOf(query - reach);
    const Cell high = cellOf(query + reach);
    const Cell count = high - low + Cell::Ones();
    const auto slots = static_cast<Real>(mask_) + 1;
    if (count.cast<Real>().prod() > slots) {
        // More cubes than slots: every point is looked at once.
        look(
            0, static_cast<std::uint32_t>(points_.size()), query, squared, [](const Vec3&) { return true; }, visit);
        return;
    }
    for (std::int64_t z = low.z(); z <= high.z(); ++z) {
        for (std::int64_t y = low.y(); y <= high.y(); ++y) {
            const Row row = {{low.x(), y, z}, high.x()};
            // The list of a slot may hold points of other cubes, which are found there, or not at all.
            const auto own = [&](const Vec3& point) { return row.contains(cellOf(point)); };
            const std::uint32_t begin = slotOf(row.low);
            const std::uint32_t end = begin + static_cast<std::uint32_t>(count.x());  // of slots, maybe beyond the last
            look(first_[begin], first_[std::min(end, mask_ + 1)], query, squared, own, visit);
            if (end > mask_ + 1) look(first_[0], first_[end - mask_ - 1], query, squared, own, visit);
        }
    }
    //! [ex-09.2]
}

}  // namespace caustic
