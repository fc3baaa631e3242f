#pragma once

#include <memory>
#include <utility>

#include "shape/shape.h"
#include "texture/normal_map.h"

namespace caustic {

/// A normal map as it stands in the books: what it says is taken, wherever it is seen from. To show what goes wrong.
class BareNormals final : public Shape {
public:
    /// Keeps both alive.
    BareNormals(std::shared_ptr<const Shape> shape, std::shared_ptr<const NormalMap> map)
        : shape_(std::move(shape)), map_(std::move(map)) {}

    std::optional<Hit> intersect(const Ray& ray) const override;
    bool occluded(const Ray& ray) const override { return shape_->occluded(ray); }
    Bounds3 bounds() const override { return shape_->bounds(); }
    std::optional<AreaSample> sampleArea(const Vec2& u) const override { return shape_->sampleArea(u); }
    Real pdfA(const SurfacePoint& at) const override { return shape_->pdfA(at); }

private:
    std::shared_ptr<const Shape> shape_;
    std::shared_ptr<const NormalMap> map_;
};

/// The normal of a map at a hit, not bent. The map's axes as mappedNormal has them.
Vec3 bareNormal(const Hit& at, const Vec3& local);

}  // namespace caustic
