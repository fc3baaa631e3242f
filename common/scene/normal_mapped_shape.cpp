#include "scene/normal_mapped_shape.h"

#include <utility>

#include "core/check.h"
#include "texture/mapped_normal.h"

namespace caustic {

NormalMappedShape::NormalMappedShape(std::shared_ptr<const Shape> shape, std::shared_ptr<const NormalMap> map)
    : shape_(std::move(shape)), map_(std::move(map)) {
    checkArgument(shape_ != nullptr, "normal-mapped shape", "", "needs a shape");
    checkArgument(map_ != nullptr, "normal-mapped shape", "", "needs a normal map");
}

std::optional<Hit> NormalMappedShape::intersect(const Ray& ray) const {
    std::optional<Hit> hit = shape_->intersect(ray);
    if (hit) hit->ns = mappedNormal(*hit, map_->at(hit->uv), -ray.direction.normalized());
    return hit;
}

}  // namespace caustic
