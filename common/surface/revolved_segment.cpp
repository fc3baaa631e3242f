#include "surface/revolved_segment.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <string>

#include "core/check.h"
#include "core/not_implemented.h"

namespace caustic {

namespace {

constexpr Real infinity = std::numeric_limits<Real>::infinity();
constexpr Real unitRoundoff = std::numeric_limits<Real>::epsilon() / 2;

Real binomial(int n, int k) {
    Real value = 1;
    for (int i = 1; i <= k; ++i) value = value * (n - k + i) / i;
    return value;
}

// Bernstein coefficients of a product (Farin, sec. 6.10).
std::vector<Real> product(const std::vector<Real>& a, const std::vector<Real>& b) {
    const int n = static_cast<int>(a.size()) - 1;
    const int m = static_cast<int>(b.size()) - 1;
    std::vector<Real> result(static_cast<std::size_t>(n + m + 1), 0);
    for (int i = 0; i <= n; ++i) {
        for (int j = 0; j <= m; ++j) {
            const Real weight = binomial(n, i) * binomial(m, j) / binomial(n + m, i + j);
            result[static_cast<std::size_t>(i + j)] +=
                weight * a[static_cast<std::size_t>(i)] * b[static_cast<std::size_t>(j)];
        }
    }
    return result;
}

Real largestOf(const std::vector<Real>& values) {
    Real largest = 0;
    for (const Real value : values) largest = std::max(largest, std::abs(value));
    return largest;
}

// A bound of the second derivative on [0, 1].
Real bendOf(std::span<const Real> c) {
    Real largest = 0;
    for (std::size_t i = 2; i < c.size(); ++i) largest = std::max(largest, std::abs(c[i] - 2 * c[i - 1] + c[i - 2]));
    const auto n = static_cast<Real>(c.size() - 1);
    return n * (n - 1) * largest;
}

// Value and derivative of a polynomial in Bernstein form. At u = 0 and 1 the value is the end's coefficient exactly, so
// that two segments that share an end agree on it.
struct Jet {
    Real value;
    Real slope;
};

Jet evaluateCubic(const Real* c, Real u) {
    const Real v = 1 - u;
    const Real ab = v * c[0] + u * c[1];
    const Real bc = v * c[1] + u * c[2];
    const Real cd = v * c[2] + u * c[3];
    const Real abc = v * ab + u * bc;
    const Real bcd = v * bc + u * cd;
    return {v * abc + u * bcd, 3 * (bcd - abc)};
}

Jet evaluateAny(const Real* c, int degree, Real u) {
    std::array<Real, RevolvedSegment::highestDegree + 1> level;
    std::copy(c, c + degree + 1, level.begin());
    for (int left = degree; left > 1; --left) {
        for (int i = 0; i < left; ++i) {
            const auto k = static_cast<std::size_t>(i);
            level[k] = (1 - u) * level[k] + u * level[k + 1];
        }
    }
    return {(1 - u) * level[0] + u * level[1], degree * (level[1] - level[0])};
}

// Both coordinates' jets at u.
struct ProfileJet {
    Jet x;
    Jet y;
};

ProfileJet evaluateProfile(const std::vector<Real>& x, const std::vector<Real>& y, Real u) {
    if (x.size() == 4) return {evaluateCubic(x.data(), u), evaluateCubic(y.data(), u)};
    const int degree = static_cast<int>(x.size()) - 1;
    return {evaluateAny(x.data(), degree, u), evaluateAny(y.data(), degree, u)};
}

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

RevolvedSegment::RevolvedSegment(const BezierCurve& profile) {
    checkArgument(profile.degree() >= 1 && profile.degree() <= highestDegree, "profile's degree",
                  std::to_string(profile.degree()), "must be 1 to " + std::to_string(highestDegree));
    for (const Vec3& point : profile.controlPoints()) {
        x_.push_back(point.x());
        y_.push_back(point.y());
    }
    const auto [low, high] = std::minmax_element(y_.begin(), y_.end());
    middle_ = *low / 2 + *high / 2;
    std::vector<Real> centred = y_;
    for (Real& y : centred) y -= middle_;
    xSquare_ = product(x_, x_);
    ySquare_ = product(centred, centred);
    yRaised_ = product(centred, std::vector<Real>(centred.size(), 1));
    xLargest_ = largestOf(x_);
    yLargest_ = largestOf(centred);
    margin_ = 1e-6 * (xLargest_ + yLargest_);
    xBend_ = bendOf(x_);
    yBend_ = bendOf(y_);
}

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
        if (addByMonotoneFactors(low, width)) return;
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

    // Appends the root with its place on the line: the projection of the meeting point onto the line, so that height
    // and distance from the axis both have their say, each with the weight that it deserves.
    void addRoot(Real u, const ProfileJet& profile, Real side) {
        const auto& [x, y] = profile;
        const Real h = y.value - ray_.baseHeight;
        if (!ray_.leaning) return roots_.add(u, h / ray_.rise);
        const Real square = (std::abs(x.value) - ray_.near) * (std::abs(x.value) + ray_.near);
        roots_.add(u, ray_.rise * h + side * ray_.flat * std::sqrt(std::max(Real(0), square)));
    }

    // Whether a circle comes as near to the axis as the line does, up to rounding.
    bool reachesLine(Real x) const {
        if (!ray_.leaning) return true;
        return std::abs(x) - ray_.near >= -32 * unitRoundoff * (segment_.xLargest_ + ray_.near);
    }

    // A zero counts as negative for one factor only: a line through the pole, where both are zero, meets it once.
    bool isNegative(Real value, Real side) const { return value < 0 || (value == 0 && !ray_.leaning && side > 0); }

    // For a leaning line: if both factors are monotone over the piece, each has at most one root there, and the signs
    // at the ends tell. The bound: |flat y'| > |rise x x' / r| throughout, by Taylor's theorem from the middle.
    // @return whether that settled the piece
    bool addByMonotoneFactors(Real low, Real width) {
        if (!ray_.leaning) return false;
        const Real half = width / 2;
        const auto [x, y] = profileAt(low + half);
        const Real ySlope = std::abs(y.slope) - half * segment_.yBend_;
        if (!(ySlope > 0)) return false;
        const Real xSlope = std::abs(x.slope) + half * segment_.xBend_;
        const Real xLow = std::abs(x.value) - half * xSlope;
        const Real xHigh = std::abs(x.value) + half * xSlope;
        if (!(xLow > ray_.near)) return false;
        const Real left = ray_.flat * ySlope;
        const Real right = ray_.rise * xHigh * xSlope;
        if (!(left * left * (xLow - ray_.near) * (xLow + ray_.near) > right * right)) return false;
        // r'' = (x x'' + x'² - r'²) / r with r' = x x' / r.
        const Real rLow = std::sqrt((xLow - ray_.near) * (xLow + ray_.near));
        const Real rSlope = xHigh * xSlope / rLow;
        const Real rBend = (xHigh * segment_.xBend_ + xSlope * xSlope + rSlope * rSlope) / rLow;
        const Real bend = ray_.flat * segment_.yBend_ + std::abs(ray_.rise) * rBend;
        for (const Real side : {Real(-1), Real(1)}) addBySigns(low, low + width, side, bend);
        return true;
    }

    // bend: a bound of the factor's second derivative, if there is one.
    void addBySigns(Real low, Real high, Real side, Real bend = infinity) {
        const auto factor = [this, side](Real u) { return factorAt(u, side); };
        const Real before = factor(low).value;
        const Real after = factor(high).value;
        const bool negativeBefore = isNegative(before, side);
        if (negativeBefore == isNegative(after, side)) return;
        const Real start = low + (high - low) * before / (before - after);
        const Real u = solve(factor, low, high, start, negativeBefore, bend);
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

std::optional<RevolvedSegment::Reach> RevolvedSegment::reach(const AxisRay& ray) const {
    Reach reach = {-infinity, infinity};
    if (std::abs(ray.rise) > 1e-6) {
        const Real middle = (middle_ - ray.baseHeight) * ray.perRise;
        const Real half = (yLargest_ + margin_) * std::abs(ray.perRise);
        reach = {middle - half, middle + half};
    }
    const Real passing = ray.acrossAt(std::clamp(ray.nearest, reach.from, reach.to)).squaredNorm();
    const Real radius = xLargest_ + margin_ + 1e-12 * ray.near;
    if (passing > radius * radius) return std::nullopt;
    return reach;
}

RevolvedSegment::ProfilePoint RevolvedSegment::profileAt(Real u) const {
    const auto [x, y] = evaluateProfile(x_, y_, u);
    return {{x.value, y.value}, {x.slope, y.slope}};
}

RevolvedSegment::Roots RevolvedSegment::roots(const AxisRay& ray) const {
    Roots roots;
    if (!std::isfinite(ray.tBase) || !std::isfinite(ray.near)) return roots;
    RevolvedRootFinder(*this, ray, roots).find();
    return roots;
}

}  // namespace caustic
