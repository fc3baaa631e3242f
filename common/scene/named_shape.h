#pragma once

#include <memory>
#include <utility>

#include "shape/shape.h"

namespace caustic {

/// A shape with an object's id, for hits that no instance within it has named. It costs less than an instance that
/// moves nothing.
class NamedShape final : public Shape {
public:
    /// Keeps the shape alive.
    NamedShape(std::shared_ptr<const Shape> shape, ObjectId object) : shape_(std::move(shape)), object_(object) {}

    std::optional<Hit> intersect(const Ray& ray) const override {
        std::optional<Hit> hit = shape_->intersect(ray);
        if (hit && hit->object == noObject) hit->object = object_;
        return hit;
    }
    bool occluded(const Ray& ray) const override { return shape_->occluded(ray); }
    Bounds3 bounds() const override { return shape_->bounds(); }
    bool bounded() const override { return shape_->bounded(); }
    std::optional<AreaSample> sampleArea(const Vec2& u) const override { return shape_->sampleArea(u); }
    Real pdfA(const SurfacePoint& at) const override { return shape_->pdfA(at); }

private:
    std::shared_ptr<const Shape> shape_;
    ObjectId object_;
};

}  // namespace caustic
