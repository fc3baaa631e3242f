#include "surface/newton_revolution.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/check.h"
#include "curve/curve_bounds.h"

namespace caustic {

namespace {

// The ring in which the revolved curve lies, a little larger, so that flat ones are rings too.
RingCylinder ringAround(const BezierCurve& curve) {
    const Bounds3 box = exactBounds(curve);
    const Real outer = std::max(std::abs(box.min().x()), std::abs(box.max().x()));
    const Real inner = box.min().x() > 0 ? box.min().x() : std::max(-box.max().x(), Real(0));
    const Real pad = 1e-9 * (outer + std::abs(box.min().y()) + std::abs(box.max().y()));
    return {std::max(inner - pad, Real(0)), outer + pad, box.min().y() - pad, box.max().y() + pad};
}

}  // namespace

NewtonRevolution::NewtonRevolution(const std::vector<BezierCurve>& profile, NewtonStartRule rule, int samples)
    : rule_(rule), samples_(samples) {
    const int most = rule == NewtonStartRule::Random ? 64 : 32;
    checkArgument(samples >= 1 && samples <= most, "samples of a segment", std::to_string(samples),
                  "must be 1 to " + std::to_string(most));
    for (const BezierCurve& curve : profile) segments_.push_back({RevolvedCurve(curve, samples), ringAround(curve)});
}

NewtonStarts NewtonRevolution::startsOn(const Segment& segment, const Ray& ray, Random& random) const {
    switch (rule_) {
        case NewtonStartRule::Random:
            return randomStarts(segment.curve, ray, samples_, random);
        case NewtonStartRule::Grid:
            return gridStarts(segment.curve, ray);
        default:
            return segment.curve.bracketingStarts(ray);
    }
}

std::optional<Real> NewtonRevolution::intersect(const Ray& ray, Random& random) const {
    Ray rest = ray;
    std::optional<Real> nearest;
    for (const Segment& segment : segments_) {
        if (segment.ring.spans(rest).count == 0) continue;
        const auto found = nearestByNewton(segment.curve, rest, startsOn(segment, rest, random));
        if (found) nearest = rest.tMax = found->t;
    }
    return nearest;
}

}  // namespace caustic
