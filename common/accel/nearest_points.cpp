#include "accel/nearest_points.h"

#include <algorithm>

#include "core/not_implemented.h"

namespace caustic {

void NearestPoints::offer(const NearPoint& point) {
    //! [ex-08.5]
    const auto nearer = [](const NearPoint& a, const NearPoint& b) { return a.squaredDistance < b.squaredDistance; };
    if (heap_.size() < wanted_) {
        heap_.push_back(point);
        if (heap_.size() < wanted_) return;
        std::make_heap(heap_.begin(), heap_.end(), nearer);
    } else if (nearer(point, heap_.front())) {
        // The hole at the top sinks along the farther children until the new point fits.
        std::size_t hole = 0;
        for (std::size_t child = 1; child < wanted_; child = 2 * hole + 1) {
            if (child + 1 < wanted_ && nearer(heap_[child], heap_[child + 1])) ++child;
            if (!nearer(point, heap_[child])) break;
            heap_[hole] = heap_[child];
            hole = child;
        }
        heap_[hole] = point;
    }
    mostSquared_ = heap_.front().squaredDistance;
    //! [ex-08.5]
}

}  // namespace caustic
