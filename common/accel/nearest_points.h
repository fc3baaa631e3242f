#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "math/real.h"

namespace caustic {

/// A point that a search found.
struct NearPoint {
    std::uint32_t place = 0;  ///< in the structure that was searched
    Real squaredDistance = 0;
};

/// The k nearest of all points that it is offered: a heap whose top is the farthest one, so that each offer costs a
/// comparison, or the way down a heap of k. Kept from search to search it allocates nothing.
class NearestPoints {
public:
    /// Forgets what it holds.
    /// @param k            how many to keep
    /// @param mostSquared  points farther than that don't count
    void start(std::size_t k, Real mostSquared) {
        heap_.clear();
        wanted_ = k;
        mostSquared_ = k > 0 ? mostSquared : -1;
    }

    /// Farther than that no point is taken any more: the limit that it started with until there are k, then the
    /// distance of the farthest one. Negative when none is wanted at all.
    Real mostSquared() const { return mostSquared_; }

    /// Takes a point if it is among the k nearest so far, in the place of the farthest one if there are k already. Of
    /// points at the same distance, those that came first stay.
    /// @param point  no farther than mostSquared()
    void offer(const NearPoint& point);

    /// What is held, in no order but that the farthest comes first once there are k.
    std::span<const NearPoint> points() const { return heap_; }
    /// Whether there are k.
    bool full() const { return heap_.size() == wanted_; }

private:
    std::vector<NearPoint> heap_;
    std::size_t wanted_ = 0;
    Real mostSquared_ = -1;
};

}  // namespace caustic
