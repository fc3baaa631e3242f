#include "light/weighted_shape.h"

#include <cmath>
#include <utility>

#include "core/check.h"

namespace caustic {

namespace {

// Images have their rows from the top, v goes up. It is its own inverse.
Vec2 turned(const Vec2& place) { return {place.x(), 1 - place.y()}; }

std::shared_ptr<const Shape> checked(std::shared_ptr<const Shape> shape) {
    checkArgument(shape != nullptr, "weighted shape", "", "needs a shape");
    const auto middle = shape->sampleArea({0.5, 0.5});
    for (const Vec2& u : {Vec2(0.5, 0.5), Vec2(0.1, 0.7), Vec2(0.9, 0.2)}) {
        const auto sample = shape->sampleArea(u);
        checkArgument(
            sample && (sample->at.uv - u).norm() < 1e-9 && std::abs(sample->pdfA - middle->pdfA) <= 1e-9 * middle->pdfA,
            "weighted shape", "", "must be sampled evenly by its u and v, as a rectangle is");
    }
    return shape;
}

}  // namespace

WeightedShape::WeightedShape(std::shared_ptr<const Shape> shape, const Image& image, Wrap wrap)
    : shape_(checked(std::move(shape))), distribution_(image, wrap, wrap, [](Real v) { return v; }) {}

std::optional<AreaSample> WeightedShape::sampleArea(const Vec2& u) const {
    const ImageDistribution::Sample place = distribution_.sample(u);
    auto sample = shape_->sampleArea(turned(place.at));
    // PBR, 4th ed., A.5: a density over the unit square, spread over the shape's area.
    if (sample) sample->pdfA *= place.pdf;
    return sample;
}

Real WeightedShape::pdfA(const SurfacePoint& at) const {
    // As in sampleArea.
    return shape_->pdfA(at) * distribution_.pdf(turned(at.uv));
}

}  // namespace caustic
