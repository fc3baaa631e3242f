#pragma once

#include <memory>

#include "image/image.h"
#include "shape/shape.h"
#include "texture/image_distribution.h"

namespace caustic {

/// A shape whose points are picked in proportion to an image's brightness over its u and v, for a lamp that shines as
/// an image does: an object's emission is then sampled where it is bright. All else is the shape's.
class WeightedShape final : public Shape {
public:
    /// @param shape  its sampleArea(u) must give the point with uv = u, and equal areas for equal areas of u: a
    /// rectangle
    /// @param image  laid on it as ImageTexture does, once
    /// @throws InputError when either is missing, the shape samples otherwise, or as ImageDistribution does
    WeightedShape(std::shared_ptr<const Shape> shape, const Image& image, Wrap wrap = Wrap::Repeat);

    std::optional<Hit> intersect(const Ray& ray) const override { return shape_->intersect(ray); }
    bool occluded(const Ray& ray) const override { return shape_->occluded(ray); }
    Bounds3 bounds() const override { return shape_->bounds(); }
    bool bounded() const override { return shape_->bounded(); }
    std::optional<AreaSample> sampleArea(const Vec2& u) const override;
    Real pdfA(const SurfacePoint& at) const override;

private:
    std::shared_ptr<const Shape> shape_;
    ImageDistribution distribution_;
};

}  // namespace caustic
