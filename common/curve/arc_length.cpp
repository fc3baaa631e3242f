#include "curve/arc_length.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <string>

#include "core/check.h"
#include "core/not_implemented.h"
#include "curve/bernstein.h"
#include "curve/gauss_legendre.h"
#include "math/stable_norm.h"

namespace caustic {

namespace {

constexpr Real unitRoundoff = std::numeric_limits<Real>::epsilon() / 2;

// The derivative of a curve, and how far rounding can take it.
class Velocity {
public:
    explicit Velocity(const BezierCurve& curve) : hodograph_(curve.hodograph()) {
        for (const Vec3& control : hodograph_.controlPoints()) largest_ = std::max(largest_, stableNorm(control));
    }

    int degree() const { return hodograph_.degree(); }
    Vec3 operator()(Real t) const { return evaluateBernstein<Vec3>(hodograph_.controlPoints(), t); }
    Real largest() const { return largest_; }

    // Differences of the control points, evaluateBernstein(), and a t that is rounded itself.
    Real error() const { return (16 * degree() + 16) * unitRoundoff * largest_; }

private:
    BezierCurve hodograph_;
    Real largest_ = 0;
};

// A part of a curve as it was measured. Pieces are sorted by their errors.
struct Piece {
    Real from;
    Real to;
    Real length;
    Real error;
    bool operator<(const Piece& other) const { return error < other.error; }
};

void checkRange(Real from, Real to) {
    checkArgument(from >= 0 && from <= 1, "from", formatReal(from), "must lie in [0, 1]");
    checkArgument(to >= from && to <= 1, "to", formatReal(to), "must lie between from and 1");
}

}  // namespace

Real chordLength(const BezierCurve& curve, int segments) {
    //! [ex-01.4]
    checkArgument(segments >= 1, "segments", std::to_string(segments), "must be at least 1");
    Real length = 0;
    Vec3 before = curve.position(0);
    for (int i = 1; i <= segments; ++i) {
        const Vec3 point = curve.position(static_cast<Real>(i) / segments);
        length += stableNorm(point - before);
        before = point;
    }
    return length;
    //! [ex-01.4]
}

LengthEstimate gaussLength(const BezierCurve& curve, Real tolerance, Real from, Real to) {
    //! [ex-01.5]
    checkPositive(tolerance, "tolerance");
    checkRange(from, to);
    const Velocity velocity(curve);
    const GaussRule rule = gaussLegendreRule(std::max(16, curve.degree()));
    int evaluations = 0;

    const auto measured = [&](Real a, Real b) {
        const Real half = (b - a) / 2;
        std::vector<Vec3> velocities;
        Real sum = 0;
        for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
            velocities.push_back(velocity(a + half * (1 + rule.nodes[i])));
            sum += rule.weights[i] * stableNorm(velocities.back());
        }
        evaluations += rule.points();
        return Piece{a, b, half * sum, half * gaussSpeedError(rule, velocities, velocity.degree(), velocity.error())};
    };

    // The worst piece is halved until all errors together are small enough: a cusp is narrowed down, the rest left
    // alone.
    constexpr std::size_t mostPieces = 4096;
    const Real rounding = (to - from) * (2 * velocity.error() + 4 * rule.points() * unitRoundoff * velocity.largest());
    const Real wanted = std::max(tolerance - rounding, rounding);
    std::priority_queue<Piece> pieces;
    pieces.push(measured(from, to));
    Real error = pieces.top().error;
    while (error > wanted && pieces.size() < mostPieces) {
        const Piece worst = pieces.top();
        pieces.pop();
        const Real middle = (worst.from + worst.to) / 2;
        const Piece left = measured(worst.from, middle);
        const Piece right = measured(middle, worst.to);
        error += left.error + right.error - worst.error;
        pieces.push(left);
        pieces.push(right);
    }

    LengthEstimate result{0, rounding, evaluations};
    for (; !pieces.empty(); pieces.pop()) {
        result.length += pieces.top().length;
        result.error += pieces.top().error;
    }
    return result;
    //! [ex-01.5]
}

std::vector<Real> evenlySpaced(const BezierCurve& curve, int count) {
    //! [ex-01.6]
    checkArgument(count >= 1, "count", std::to_string(count), "must be at least 1");
    const Velocity velocity(curve);
    std::vector<Real> cuts;
    if (velocity.largest() == 0) {
        for (int i = 0; i <= count; ++i) cuts.push_back(static_cast<Real>(i) / count);
        return cuts;
    }
    const Real total = gaussLength(curve, 1e-12 * velocity.largest()).length;
    const Real accuracy = 1e-10 * total / count;

    Real t = 0;
    Real reached = 0;  // length of the curve up to t
    cuts.push_back(0);
    for (int i = 1; i < count; ++i) {
        const Real wanted = total * i / count;
        Real low = t;
        Real high = 1;
        for (int step = 0; std::abs(wanted - reached) > accuracy && step < 100; ++step) {
            (reached < wanted ? low : high) = t;
            // Newton's step; bisection where it leaves the bracket, at a cusp say, or takes too long.
            Real next = t + (wanted - reached) / stableNorm(velocity(t));
            if (!(next > low && next < high) || step > 30) next = (low + high) / 2;
            if (next > t) reached += gaussLength(curve, accuracy / 100, t, next).length;
            if (next < t) reached -= gaussLength(curve, accuracy / 100, next, t).length;
            t = next;
        }
        cuts.push_back(t);
    }
    cuts.push_back(1);
    return cuts;
    //! [ex-01.6]
}

}  // namespace caustic
