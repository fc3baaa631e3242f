#include "shape/instance.h"

#include <utility>

#include "core/check.h"
#include "core/not_implemented.h"

namespace caustic {

Instance::Instance(std::shared_ptr<const Shape> shape, const Transform& toWorld, ObjectId object)
    : shape_(std::move(shape)), toWorld_(toWorld), toLocal_(toWorld.inverse()), object_(object) {
    checkArgument(shape_ != nullptr, "instance", "", "needs a shape");
}

std::optional<Hit> Instance::intersect(const Ray& ray) const {
    //! [ex-02.7]
    std::optional<Hit> hit = shape_->intersect(toLocal_.ray(ray));
    if (!hit) return std::nullopt;

    static_cast<SurfacePoint&>(*hit) = toWorld_.surfacePoint(*hit);
    hit->ns = toWorld_.normal(hit->ns);
    hit->dpdu = toWorld_.vector(hit->dpdu);
    hit->dpdv = toWorld_.vector(hit->dpdv);
    if (hit->object == noObject) hit->object = object_;
    return hit;
    //! [ex-02.7]
}

bool Instance::occluded(const Ray& ray) const { return shape_->occluded(toLocal_.ray(ray)); }

std::optional<AreaSample> Instance::sampleArea(const Vec2& u) const {
    const std::optional<AreaSample> local = shape_->sampleArea(u);
    if (!local) return std::nullopt;
    return AreaSample{toWorld_.surfacePoint(local->at), local->pdfA / toWorld_.areaScale(local->at.ng)};
}

Real Instance::pdfA(const SurfacePoint& at) const {
    const SurfacePoint local = toLocal_.surfacePoint(at);
    return shape_->pdfA(local) / toWorld_.areaScale(local.ng);
}

}  // namespace caustic
