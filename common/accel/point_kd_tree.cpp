#include "accel/point_kd_tree.h"

#include <algorithm>

#include "core/check.h"

namespace caustic {

namespace {

constexpr float notANumber = std::numeric_limits<float>::quiet_NaN();
constexpr Real roundoff = std::numeric_limits<float>::epsilon() / 2;

// (d + e)² ≤ d² (1 + η) + e² (1 + 1/η) for any η > 0: what rounding adds to a squared distance without a square root.
constexpr Real eta = 0x1p-12;

constexpr Real farthest = 1e150;  // squares stay finite

// Of a complete binary tree with so many leaves: those below the root's left child. The last level is filled from left.
std::uint32_t leftLeaves(std::uint32_t leaves) {
    const std::uint32_t fullLevel = std::bit_floor(leaves);
    return fullLevel == leaves ? leaves / 2 : fullLevel / 2 + std::min(leaves - fullLevel, fullLevel / 2);
}

}  // namespace

// A point on its way to its leaf: small, since it is moved at every level.
struct PointKdTree::Item {
    Eigen::Vector3f at;
    std::uint32_t index;
};

PointKdTree::PointKdTree(std::span<const Vec3> points) {
    checkArgument(points.size() < std::numeric_limits<std::uint32_t>::max(), "points of a tree",
                  std::to_string(points.size()), "takes fewer than 2^32 points");
    if (points.empty()) return;
    Bounds3 box;
    for (const Vec3& point : points) {
        checkArgument((point.array().abs() <= farthest).all(), "a point's coordinates",
                      formatReal(point.x()) + ", " + formatReal(point.y()) + ", " + formatReal(point.z()),
                      "must be finite and at most 1e150");
        box.extend(point);
    }
    center_ = box.center();
    int exponent = 0;
    std::frexp(box.sizes().maxCoeff(), &exponent);  // the box's size in units is at most 1
    scale_ = std::ldexp(Real(1), std::clamp(-exponent, -500, 500));

    std::vector<Item> items(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vec3 local = scale_ * (points[i] - center_);
        items[i] = {local.cast<float>(), static_cast<std::uint32_t>(i)};
    }
    const auto leaves = static_cast<std::uint32_t>((points.size() + leafSize - 1) / leafSize);
    planes_.resize(leaves - 1);
    leaves_.resize(leaves);
    lastLevel_ = std::bit_ceil(leaves) - 1;
    points_.resize(points.size());
    order_.resize(points.size());
    build(items, 0, 0, leaves);
    for (std::size_t place = 0; place < points.size(); ++place) points_[place] = points[order_[place]];
}

// The items are those of some leaves in a row; the tree over them is complete.
void PointKdTree::build(std::span<Item> items, std::uint32_t node, std::uint32_t firstLeaf, std::uint32_t leaves) {
    if (leaves == 1) {
        for (int axis = 0; axis < 3; ++axis) {
            Float8& lanes = leaves_[firstLeaf].coordinate[static_cast<std::size_t>(axis)];
            lanes = broadcast8(notANumber);
            for (std::size_t i = 0; i < items.size(); ++i) lanes[i] = items[i].at[axis];
        }
        for (std::size_t i = 0; i < items.size(); ++i) order_[leafSize * firstLeaf + i] = items[i].index;
        return;
    }
    Eigen::Vector3f low = items.front().at;
    Eigen::Vector3f high = low;
    for (const Item& item : items) {
        low = low.cwiseMin(item.at);
        high = high.cwiseMax(item.at);
    }
    int axis = 0;
    (high - low).maxCoeff(&axis);
    const std::uint32_t left = leftLeaves(leaves);
    const std::size_t middle = std::size_t{leafSize} * left;
    std::nth_element(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(middle), items.end(),
                     [axis](const Item& a, const Item& b) { return a.at[axis] < b.at[axis]; });
    planes_[node] = {items[middle].at[axis], static_cast<std::uint32_t>(axis)};
    build(items.first(middle), 2 * node + 1, firstLeaf, left);
    build(items.subspan(middle), 2 * node + 2, firstLeaf + left, leaves - left);
}

std::size_t PointKdTree::memory() const {
    return planes_.size() * sizeof(Plane) + leaves_.size() * sizeof(Leaf) + points_.size() * sizeof(Vec3) +
           order_.size() * sizeof(std::uint32_t);
}

PointKdTree::FloatQuery PointKdTree::toFloat(const Vec3& query) const {
    const Vec3 local = scale_ * (query - center_);
    // Each coordinate is rounded once, the points' and the query's, and so is their difference.
    const Real off = 2 * roundoff * (1 + local.cwiseAbs().maxCoeff());
    return {{static_cast<float>(local.x()), static_cast<float>(local.y()), static_cast<float>(local.z())},
            scale_ * scale_,
            3 * off * off * (1 + 1 / eta)};
}

float PointKdTree::FloatQuery::reach(Real mostSquared) const {
    // Twice η: the other one is room for the rounding of squares, sums and of this.
    return static_cast<float>(mostSquared * scale * (1 + 2 * eta) + margin);
}

}  // namespace caustic
