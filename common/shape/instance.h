#pragma once

#include <memory>

#include "math/transform.h"
#include "shape/shape.h"

namespace caustic {

/// A shape seen through an affine transform: the ray is taken to the shape's own space, and the hit back.
///
/// Instances may share a shape, stand in groups, and hold groups. One may name the object that the shape is part of; a
/// Hit keeps the name that the innermost instance gives.
class Instance final : public Shape {
public:
    /// @throws InputError when there is no shape
    Instance(std::shared_ptr<const Shape> shape, const Transform& toWorld, ObjectId object = noObject);

    std::optional<Hit> intersect(const Ray& ray) const override;
    bool occluded(const Ray& ray) const override;
    Bounds3 bounds() const override { return toWorld_.bounds(shape_->bounds()); }
    bool bounded() const override { return shape_->bounded(); }

    /// Uniform where the shape's own sampling is and the transform scales all directions alike. Otherwise area is
    /// stretched more in some places than in others, and pdfA says by how much.
    std::optional<AreaSample> sampleArea(const Vec2& u) const override;
    Real pdfA(const SurfacePoint& at) const override;

private:
    std::shared_ptr<const Shape> shape_;
    Transform toWorld_;
    Transform toLocal_;
    ObjectId object_;
};

}  // namespace caustic
