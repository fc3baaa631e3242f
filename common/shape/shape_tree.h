#pragma once

#include <memory>
#include <vector>

#include "accel/kd_tree.h"
#include "shape/shape.h"

namespace caustic {

/// A group with a KD-tree over its members. These may be meshes, instances, groups, and other trees: trees in trees.
///
/// Gives the same hits as a Group does. Members without a finite box stay out of the tree and are asked first.
class ShapeTree final : public Shape {
public:
    /// @throws InputError when there is no member, or one is null
    explicit ShapeTree(const std::vector<std::shared_ptr<const Shape>>& members);

    std::optional<Hit> intersect(const Ray& ray) const override;
    bool occluded(const Ray& ray) const override;
    Bounds3 bounds() const override { return bounds_; }
    bool bounded() const override { return unbounded_.empty(); }
    std::optional<AreaSample> sampleArea(const Vec2&) const override { return std::nullopt; }
    Real pdfA(const SurfacePoint&) const override { return 0; }

private:
    std::vector<std::shared_ptr<const Shape>> unbounded_;
    std::vector<std::shared_ptr<const Shape>> members_;  // items of the tree
    KdTree tree_;
    Bounds3 bounds_;
};

}  // namespace caustic
