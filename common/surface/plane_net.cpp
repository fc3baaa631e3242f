#include "surface/plane_net.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/not_implemented.h"

namespace caustic {

namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

// The mean derivatives by u and v: differences of opposite sides' means.
struct MeanDerivatives {
    Vec2 u;
    Vec2 v;
};

MeanDerivatives meanDerivatives(const PlaneNet& net) {
    MeanDerivatives mean = {Vec2::Zero(), Vec2::Zero()};
    for (int j = 0; j <= net.degreeV; ++j) mean.u += net.point[index(net.degreeU)][index(j)] - net.point[0][index(j)];
    for (int i = 0; i <= net.degreeU; ++i) mean.v += net.point[index(i)][index(net.degreeV)] - net.point[index(i)][0];
    return {mean.u / (net.degreeV + 1), mean.v / (net.degreeU + 1)};
}

}  // namespace

bool isOneToOne(const PlaneNet& net) {
    const MeanDerivatives mean = meanDerivatives(net);
    const Real determinant = crossOf(mean.u, mean.v);
    if (determinant == 0) return false;
    Real alongU = std::numeric_limits<Real>::infinity();
    Real alongV = alongU;
    Real asideU = 0;
    Real asideV = 0;
    for (int i = 0; i <= net.degreeU; ++i) {
        for (int j = 0; j <= net.degreeV; ++j) {
            const Vec2& here = net.point[index(i)][index(j)];
            if (i < net.degreeU) {
                const Vec2 step = net.degreeU * (net.point[index(i + 1)][index(j)] - here);
                alongU = std::min(alongU, crossOf(step, mean.v) / determinant);
                asideU = std::max(asideU, std::abs(crossOf(mean.u, step) / determinant));
            }
            if (j < net.degreeV) {
                const Vec2 step = net.degreeV * (net.point[index(i)][index(j + 1)] - here);
                alongV = std::min(alongV, crossOf(mean.u, step) / determinant);
                asideV = std::max(asideV, std::abs(crossOf(step, mean.v) / determinant));
            }
        }
    }
    return alongU > 0 && alongV > 0 && alongU * alongV > asideU * asideV;
}

void halveU(const PlaneNet& net, PlaneNet& first, PlaneNet& second) {
    first.degreeU = second.degreeU = net.degreeU;
    first.degreeV = second.degreeV = net.degreeV;
    for (int j = 0; j <= net.degreeV; ++j) {
        for (int i = 0; i <= net.degreeU; ++i) second.point[index(i)][index(j)] = net.point[index(i)][index(j)];
        for (int i = 0; i <= net.degreeU; ++i) {
            first.point[index(i)][index(j)] = second.point[0][index(j)];
            for (int k = 0; k < net.degreeU - i; ++k) {
                Vec2& p = second.point[index(k)][index(j)];
                p = (p + second.point[index(k + 1)][index(j)]) / 2;
            }
        }
    }
}

void halveV(const PlaneNet& net, PlaneNet& first, PlaneNet& second) {
    first.degreeU = second.degreeU = net.degreeU;
    first.degreeV = second.degreeV = net.degreeV;
    for (int i = 0; i <= net.degreeU; ++i) {
        auto& rest = second.point[index(i)];
        rest = net.point[index(i)];
        for (int j = 0; j <= net.degreeV; ++j) {
            first.point[index(i)][index(j)] = rest[0];
            for (int k = 0; k < net.degreeV - j; ++k) rest[index(k)] = (rest[index(k)] + rest[index(k + 1)]) / 2;
        }
    }
}

PatchDomain clippedDomain(const PlaneNet& net, Real tolerance) {
    //! [ex-03.8]
    const MeanDerivatives mean = meanDerivatives(net);
    const Real determinant = crossOf(mean.u, mean.v);
    // Less than that is a map seen edge-on, or folded over: its inverse would only magnify rounding.
    if (std::abs(determinant) <= 1e-6 * mean.u.norm() * mean.v.norm()) return {};
    constexpr Real infinity = std::numeric_limits<Real>::infinity();
    PatchDomain left = {{infinity, -infinity}, {infinity, -infinity}};
    for (int i = 0; i <= net.degreeU; ++i) {
        for (int j = 0; j <= net.degreeV; ++j) {
            const Vec2& p = net.point[index(i)][index(j)];
            const Real u = Real(i) / net.degreeU - crossOf(p, mean.v) / determinant;
            const Real v = Real(j) / net.degreeV - crossOf(mean.u, p) / determinant;
            left = {{std::min(left.u.lower, u), std::max(left.u.upper, u)},
                    {std::min(left.v.lower, v), std::max(left.v.upper, v)}};
        }
    }
    const Real padU = tolerance * mean.v.lpNorm<1>() / std::abs(determinant);
    const Real padV = tolerance * mean.u.lpNorm<1>() / std::abs(determinant);
    const auto within = [](const Interval& interval, Real pad) {
        const Interval padded = {interval.lower - pad, interval.upper + pad};
        return Interval{std::max(padded.lower, Real(0)), std::min(padded.upper, Real(1))};
    };
    return {within(left.u, padU), within(left.v, padV)};
    //! [ex-03.8]
}

}  // namespace caustic
