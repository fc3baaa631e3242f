#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "core/not_implemented.h"
#include "surface/revolved_polynomial.h"
#include "surface/revolved_segment.h"

namespace caustic {

namespace {

using detail::bendOf;
using detail::evaluateProfile;
using detail::Jet;
using detail::ProfileJet;

constexpr Real infinity = std::numeric_limits<Real>::infinity();
constexpr Real unitRoundoff = std::numeric_limits<Real>::epsilon() / 2;

// De Casteljau's algorithm at 1/2: the coefficients c over the left half and over the right one. What is left of a
// cubic profile's seven stays in registers, which makes a test 10 % faster.
template <std::size_t most>
void halve(std::span<const Real> c, Real* left, Real* right) {
    const std::size_t count = most == 7 ? 7 : c.size();
    std::array<Real, most> rest;
    std::copy_n(c.begin(), count, rest.begin());
#pragma GCC unroll 8
    for (std::size_t i = 0; i < count; ++i) {
        left[i] = rest[0];
#pragma GCC unroll 8
        for (std::size_t j = 0; j + 1 < count - i; ++j) rest[j] = (rest[j] + rest[j + 1]) / 2;
        right[count - 1 - i] = rest[count - 1 - i];
    }
}

}  // namespace

RevolvedSegment::Equation RevolvedSegment::equation(const AxisRay& ray) const {
    //! [ex-03.6]
    Equation f;
    f.degree = 2 * degree();
    const Real height = middle_ - ray.baseHeight;  // h = (y - middle) + height
    const Real riseSquare = ray.rise * ray.rise;
    const Real nearSquare = ray.near * ray.near;
    const Real half = ray.drift * ray.rise + ray.flatSquare * height;
    const Real constant = riseSquare * nearSquare + (ray.drift * ray.rise + half) * height;
    for (std::size_t i = 0; i <= static_cast<std::size_t>(f.degree); ++i) {
        f.coefficient[i] = ray.flatSquare * ySquare_[i] + 2 * half * yRaised_[i] - riseSquare * xSquare_[i] + constant;
    }
    // Each product, sum and binomial weight on the way rounds once: fewer than 16 + 2 · degree times in all, each time
    // by at most one unit of the sum of the terms' magnitudes.
    const Real h = std::abs(height) + yLargest_;
    const Real terms = ray.flatSquare * h * h + 2 * std::abs(ray.drift * ray.rise) * h +
                       riseSquare * (xLargest_ * xLargest_ + nearSquare);
    f.error = (16 + 2 * f.degree) * unitRoundoff * terms;
    return f;
    //! [ex-03.6]
}

// The search for the roots of one segment and one line.
class RevolvedRootFinder {
public:
    RevolvedRootFinder(const RevolvedSegment& segment, const AxisRay& ray, RevolvedSegment::Roots& roots)
        : segment_(segment), ray_(ray), roots_(roots) {}

    void find() { isolate(segment_.equation(ray_), 0, 1, 0); }

private:
    using Equation = RevolvedSegment::Equation;

    // Below a width of 2^-27 roots that are still together are told apart by the factors, or not at all: over so short
    // a piece f is a parabola but for rounding.
    static constexpr int deepest = 27;

    // What the signs of the coefficients tell.
    struct Signs {
        bool one;           // all the same, whatever the errors are: no root
        bool crossingOnce;  // one change between ends that are certain: one root
        Real magnitude;     // the largest coefficient
    };

    static Signs signsOf(const Equation& f) {
        Real least = f.coefficient[0];
        Real most = f.coefficient[0];
        int changes = 0;
        for (std::size_t i = 1; i <= static_cast<std::size_t>(f.degree); ++i) {
            least = std::min(least, f.coefficient[i]);
            most = std::max(most, f.coefficient[i]);
            changes += (f.coefficient[i] < 0) != (f.coefficient[i - 1] < 0) ? 1 : 0;
        }
        const Real first = f.coefficient[0];
        const Real last = f.coefficient[static_cast<std::size_t>(f.degree)];
        const bool endsAreCertain = std::abs(first) > f.error && std::abs(last) > f.error;
        return {least > f.error || most < -f.error, changes == 1 && endsAreCertain, std::max(-least, most)};
    }

    // Finds the roots in [low, low + width], where f is the equation over that piece.
    void isolate(const Equation& f, Real low, Real width, int depth) {
        //! [ex-03.7]
        const Signs signs = signsOf(f);
        if (signs.one) return;
        if (signs.crossingOnce) return addCrossing(f, low, width);
        if (depth >= deepest || signs.magnitude <= 4 * f.error) return addByFactors(low, low + width);

        Equation left;
        Equation right;
        left.degree = right.degree = f.degree;
        left.error = right.error = f.error + f.degree * unitRoundoff * signs.magnitude;
        const std::span<const Real> whole(f.coefficient.data(), static_cast<std::size_t>(f.degree) + 1);
        const auto halves = whole.size() == 7 ? halve<7> : halve<2 * RevolvedSegment::highestDegree + 1>;
        halves(whole, left.coefficient.data(), right.coefficient.data());
        isolate(left, low, width / 2, depth + 1);
        isolate(right, low + width / 2, width / 2, depth + 1);
        //! [ex-03.7]
    }

    ProfileJet profileAt(Real u) const { return evaluateProfile(segment_.x_, segment_.y_, u); }

    // f and f' from the profile itself: fewer terms than the Bernstein form, and differences of squares as products.
    Jet fAt(Real u) const {
        const auto [x, y] = profileAt(u);
        const Real h = y.value - ray_.baseHeight;
        const Real riseSquare = ray_.rise * ray_.rise;
        if (ray_.leaning) {
            const Real value = ray_.flatSquare * h * h - riseSquare * (x.value - ray_.near) * (x.value + ray_.near);
            return {value, 2 * (ray_.flatSquare * h * y.slope - riseSquare * x.value * x.slope)};
        }
        const Vec2 at = ray_.acrossAt(h / ray_.rise);
        const Real distance = at.norm();
        return {riseSquare * (distance - x.value) * (distance + x.value),
                2 * (ray_.rise * at.dot(ray_.across) * y.slope - riseSquare * x.value * x.slope)};
    }

    // The factor of f that belongs to one side. Leaning: flat h ∓ rise r, whose root lies behind the base point (side =
    // 1) or before it (-1). Otherwise: x ∓ the line's distance from the axis.
    Jet factorAt(Real u, Real side) const {
        const auto [x, y] = profileAt(u);
        const Real h = y.value - ray_.baseHeight;
        if (!ray_.leaning) {
            const Vec2 at = ray_.acrossAt(h / ray_.rise);
            const Real distance = at.norm();
            const Real growth = distance > 0 ? at.dot(ray_.across) / (distance * ray_.rise) : 0;
            return {x.value - side * distance, x.slope - side * growth * y.slope};
        }
        const Real square = (std::abs(x.value) - ray_.near) * (std::abs(x.value) + ray_.near);
        if (square <= 0) return {ray_.flat * h, ray_.flat * y.slope};
        const Real r = std::sqrt(square);
        return {ray_.flat * h - side * ray_.rise * r, ray_.flat * y.slope - side * ray_.rise * x.value * x.slope / r};
    }

    // Newton's method in a bracket where the function changes its sign; bisection where Newton would leave it or lags.
    // After a step s it is off by no more than bend s² / (2 slope): `bend` bounds the second derivative in the bracket.
    template <typename Function>
    static Real solve(const Function& function, Real low, Real high, Real start, bool risesFromBelow, Real bend) {
        Real u = start;
        Real lastStep = high - low;
        for (int i = 0; i < 100; ++i) {
            const Jet f = function(u);
            if (f.value == 0) return u;
            ((f.value < 0) == risesFromBelow ? low : high) = u;
            Real next = u - f.value / f.slope;
            const bool halve = !(next >= low && next <= high) || std::abs(next - u) > lastStep / 2;
            if (halve) next = low + (high - low) / 2;
            const Real step = std::abs(next - u);
            u = next;
            if (step <= 2 * unitRoundoff || step <= 4 * unitRoundoff * u) return u;
            if (!halve && bend * step * step <= unitRoundoff * std::abs(f.slope)) return u;
            lastStep = step;
        }
        return u;
    }

    // Where the polygon of the coefficients crosses zero: near the root, if there is one.
    static Real guess(const Equation& f, Real low, Real width) {
        std::size_t i = 1;
        while ((f.coefficient[i] < 0) == (f.coefficient[0] < 0)) ++i;
        const Real before = f.coefficient[i - 1];
        const Real along = static_cast<Real>(i - 1) + before / (before - f.coefficient[i]);
        return low + width * along / f.degree;
    }

    // f has one root in the piece and is certain of its signs at the ends.
    void addCrossing(const Equation& f, Real low, Real width) {
        const auto function = [this](Real at) { return fAt(at); };
        const Real start = guess(f, low, width);
        const Real bend = bendOf(std::span(f.coefficient).first(static_cast<std::size_t>(f.degree) + 1));
        const Real u = solve(function, low, low + width, start, f.coefficient[0] < 0, bend / (width * width));
        const ProfileJet profile = profileAt(u);
        const Real h = profile.y.value - ray_.baseHeight;
        addRoot(u, profile, (h < 0) == (ray_.rise < 0) ? 1 : -1);
    }

    // Adds the root with its place on the line, from the height or from the distance to the axis: that of the two which
    // an error of u moves less. On a disc the height is exact, but where the line comes nearest to the axis the
    // distance grows with the root of its own error: a ray that leaves the disc there would meet it again.
    void addRoot(Real u, const ProfileJet& profile, Real side) {
        const auto& [x, y] = profile;
        const Real h = y.value - ray_.baseHeight;
        if (!ray_.leaning) return roots_.add(u, h / ray_.rise);
        const Real square = (std::abs(x.value) - ray_.near) * (std::abs(x.value) + ray_.near);
        const Real r = std::sqrt(std::max(Real(0), square));
        // By du, h / rise moves by y' / rise du, and r / flat by x x' / (r flat) du.
        const bool byHeight = std::abs(y.slope) * r * ray_.flat < std::abs(x.value * x.slope * ray_.rise);
        roots_.add(u, byHeight ? h / ray_.rise : side * r / ray_.flat);
    }

    // Whether a circle comes as near to the axis as the line does, up to rounding.
    bool reachesLine(Real x) const {
        if (!ray_.leaning) return true;
        return std::abs(x) - ray_.near >= -32 * unitRoundoff * (segment_.xLargest_ + ray_.near);
    }

    // A zero counts as negative for one factor only: a line through the pole, where both are zero, meets it once.
    bool isNegative(Real value, Real side) const { return value < 0 || (value == 0 && !ray_.leaning && side > 0); }

    // The root of a factor that is monotone in the piece, if its signs at the ends say that there is one.
    void addBySigns(Real low, Real high, Real side) {
        const auto factor = [this, side](Real u) { return factorAt(u, side); };
        const Real before = factor(low).value;
        const Real after = factor(high).value;
        const bool negativeBefore = isNegative(before, side);
        if (negativeBefore == isNegative(after, side)) return;
        const Real start = low + (high - low) * before / (before - after);
        const Real u = solve(factor, low, high, start, negativeBefore, infinity);
        const ProfileJet profile = profileAt(u);
        if (reachesLine(profile.x.value)) addRoot(u, profile, side);
    }

    // How near the profile is to where its circle just reaches a leaning line; the root of the factors begins there.
    Real beyondLine(Real u) const { return std::abs(profileAt(u).x.value) - ray_.near; }

    // Roots that f can't tell apart, within a tiny piece. Where it crosses the place from which the circles reach the
    // line (near a pole, say), only the part beyond counts.
    void addByFactors(Real low, Real high) {
        if (ray_.leaning && (beyondLine(low) <= 0) != (beyondLine(high) <= 0)) {
            const bool lowReaches = beyondLine(low) > 0;
            Real a = low;
            Real b = high;
            for (int i = 0; i < 60 && b - a > 2 * unitRoundoff; ++i) {
                const Real middle = a + (b - a) / 2;
                ((beyondLine(middle) > 0) == lowReaches ? a : b) = middle;
            }
            // The end on the near side, where the factors are still flat h; just beyond it r shoots up.
            for (const Real side : {Real(-1), Real(1)}) {
                if (lowReaches) addTurning(low, b, side, factorAt(low, side).slope < 0, side * ray_.rise < 0);
                if (!lowReaches) addTurning(a, high, side, side * ray_.rise > 0, factorAt(high, side).slope < 0);
            }
            return;
        }
        for (const Real side : {Real(-1), Real(1)}) {
            addTurning(low, high, side, factorAt(low, side).slope < 0, factorAt(high, side).slope < 0);
        }
    }

    // The roots of a factor that turns at most once within the piece, falling at its ends or not.
    void addTurning(Real low, Real high, Real side, bool fallingAtLow, bool fallingAtHigh) {
        if (fallingAtLow == fallingAtHigh) return addBySigns(low, high, side);
        Real a = low;
        Real b = high;
        for (int i = 0; i < 60 && b - a > 2 * unitRoundoff; ++i) {
            const Real middle = a + (b - a) / 2;
            ((factorAt(middle, side).slope < 0) == fallingAtLow ? a : b) = middle;
        }
        addBySigns(low, a, side);
        addBySigns(a, high, side);
    }

    const RevolvedSegment& segment_;
    const AxisRay& ray_;
    RevolvedSegment::Roots& roots_;
};

RevolvedSegment::Roots RevolvedSegment::roots(const AxisRay& ray) const {
    Roots roots;
    if (!std::isfinite(ray.tBase) || !std::isfinite(ray.near)) return roots;
    RevolvedRootFinder(*this, ray, roots).find();
    return roots;
}

}  // namespace caustic
