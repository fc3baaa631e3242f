#pragma once

#include <memory>

#include "shape/shape.h"
#include "texture/normal_map.h"

namespace caustic {

/// A shape with a normal map on it: its hits have the map's shading normal (mappedNormal), and all else is the shape's.
/// A shape is asked with a ray, so it knows wo, which a material isn't told when it builds a BSDF.
class NormalMappedShape final : public Shape {
public:
    /// Keeps both alive.
    /// @throws InputError when either is missing
    NormalMappedShape(std::shared_ptr<const Shape> shape, std::shared_ptr<const NormalMap> map);

    std::optional<Hit> intersect(const Ray& ray) const override;
    bool occluded(const Ray& ray) const override { return shape_->occluded(ray); }
    Bounds3 bounds() const override { return shape_->bounds(); }
    bool bounded() const override { return shape_->bounded(); }
    std::optional<AreaSample> sampleArea(const Vec2& u) const override { return shape_->sampleArea(u); }
    Real pdfA(const SurfacePoint& at) const override { return shape_->pdfA(at); }

private:
    std::shared_ptr<const Shape> shape_;
    std::shared_ptr<const NormalMap> map_;
};

}  // namespace caustic
