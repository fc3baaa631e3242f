#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "math/real.h"

namespace caustic {

/// A point that a search found.
struct NearPoint {
    std::uint32_t place = 0;  ///< in the structure that was searched
    Real squaredDistance = 0;
};

/// The k nearest of all points that it is offered: a heap whose top is the farthest one, so that each offer costs one
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

    /// Farther than that no point is taken any more; negative when none is wanted at all.
    Real mostSquared() const { return mostSquared_; }

    /// Takes a point if it is among the k nearest so far. Of points at the same distance, those that came first stay.
    /// @param point  no farther than mostSquared()
    void offer(const NearPoint& point) {
        if (heap_.size() < wanted_) {
            heap_.push_back(point);
            if (heap_.size() < wanted_) return;
            std::make_heap(heap_.begin(), heap_.end(), nearer);
        } else if (point.squaredDistance < heap_.front().squaredDistance) {
            replaceTop(point);
        }
        mostSquared_ = heap_.front().squaredDistance;
    }

    /// What is held, in no order but that the farthest comes first once there are k.
    std::span<const NearPoint> points() const { return heap_; }
    /// Whether there are k.
    bool full() const { return heap_.size() == wanted_; }

private:
    static bool nearer(const NearPoint& a, const NearPoint& b) { return a.squaredDistance < b.squaredDistance; }

    // The hole at the top sinks along the farther children until the new point fits.
    void replaceTop(const NearPoint& point) {
        const std::size_t count = heap_.size();
        std::size_t hole = 0;
        for (std::size_t child = 1; child < count; child = 2 * hole + 1) {
            if (child + 1 < count && nearer(heap_[child], heap_[child + 1])) ++child;
            if (!nearer(point, heap_[child])) break;
            heap_[hole] = heap_[child];
            hole = child;
        }
        heap_[hole] = point;
    }

    std::vector<NearPoint> heap_;
    std::size_t wanted_ = 0;
    Real mostSquared_ = -1;
};

}  // namespace caustic
