#include "surface/revolved_curve.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <string>

#include "core/check.h"
#include "core/not_implemented.h"
#include "curve/bernstein.h"

namespace caustic {

namespace {

constexpr Real turn = 2 * std::numbers::pi;

}  // namespace

RevolvedCurve::RevolvedCurve(const BezierCurve& profile, int samples) {
    checkArgument(profile.degree() >= 1, "profile's degree", std::to_string(profile.degree()), "must be at least 1");
    checkArgument(samples >= 1, "samples of a profile", std::to_string(samples), "must be at least 1");
    for (const Vec3& point : profile.controlPoints()) {
        x_.push_back(point.x());
        y_.push_back(point.y());
    }
    const BezierCurve hodograph = profile.hodograph();
    for (const Vec3& slope : hodograph.controlPoints()) {
        xSlope_.push_back(slope.x());
        ySlope_.push_back(slope.y());
    }
    for (int i = 0; i <= samples; ++i) {
        const Real u = Real(i) / samples;
        samples_.push_back({u, evaluateBernstein<Real>(x_, u), evaluateBernstein<Real>(y_, u)});
    }
}

SurfaceJet RevolvedCurve::evaluate(Real u, Real v) const {
    const Real c = std::cos(turn * v);
    const Real s = std::sin(turn * v);
    const Real x = evaluateBernstein<Real>(x_, u);
    const Real xSlope = evaluateBernstein<Real>(xSlope_, u);
    return {{x * c, evaluateBernstein<Real>(y_, u), x * s},
            {xSlope * c, evaluateBernstein<Real>(ySlope_, u), xSlope * s},
            {-turn * x * s, 0, turn * x * c}};
}

NewtonStarts RevolvedCurve::bracketingStarts(const Ray& ray) const {
    //! [ex-03.5]
    NewtonStarts starts;
    if (ray.direction.y() == 0) return starts;
    const auto crossing = [&](const Sample& sample) { return (sample.height - ray.origin.y()) / ray.direction.y(); };
    const auto isInside = [&](const Sample& sample, Real t) {
        const Vec3 at = ray.at(t);
        return at.x() * at.x() + at.z() * at.z() < sample.radius * sample.radius;
    };
    const auto startAtSample = [&](const Sample& sample, Real t) {
        const Vec3 at = ray.at(t);
        const Real side = sample.radius < 0 ? -1 : 1;
        starts.add({t, sample.u, std::atan2(side * at.z(), side * at.x()) / turn});
    };
    Real tBefore = crossing(samples_.front());
    bool insideBefore = isInside(samples_.front(), tBefore);
    for (std::size_t i = 1; i < samples_.size(); ++i) {
        const Real t = crossing(samples_[i]);
        const bool inside = isInside(samples_[i], t);
        if (inside != insideBefore) {
            startAtSample(samples_[i - 1], tBefore);
            startAtSample(samples_[i], t);
        }
        tBefore = t;
        insideBefore = inside;
    }
    return starts;
    //! [ex-03.5]
}

}  // namespace caustic
