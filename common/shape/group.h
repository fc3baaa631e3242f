#pragma once

#include <memory>
#include <vector>

#include "shape/shape.h"

namespace caustic {

/// Several shapes as one. Groups may hold groups and instances of groups, which makes a hierarchy: a ray that misses
/// the box around a group costs one test. Within the group every shape is tried; chapter 04 plants a tree instead.
class Group final : public Shape {
public:
    /// @throws InputError when there is no member, or one is null
    explicit Group(std::vector<std::shared_ptr<const Shape>> members);

    std::optional<Hit> intersect(const Ray& ray) const override;
    bool occluded(const Ray& ray) const override;
    Bounds3 bounds() const override { return bounds_; }
    bool bounded() const override { return bounded_; }
    std::optional<AreaSample> sampleArea(const Vec2&) const override { return std::nullopt; }
    Real pdfA(const SurfacePoint&) const override { return 0; }

private:
    std::vector<std::shared_ptr<const Shape>> members_;
    Bounds3 bounds_;
    bool bounded_ = true;
};

}  // namespace caustic
