#pragma once

#include <array>
#include <optional>
#include <vector>

#include "curve/bezier_curve.h"
#include "surface/axis_ray.h"

namespace caustic {

/// Where a line meets a revolved segment.
struct RevolvedRoot {
    Real u;         ///< parameter of the profile, in [0, 1]
    Real distance;  ///< along the AxisRay, in lengths of space from its base
};

/// One Bézier curve of a profile, turned around the y axis: |x| is the distance from the axis, y the height.
///
/// Finds all its meetings with a line and misses none. With h(u) = y(u) - baseHeight the line and the circle of radius
/// |x(u)| at height y(u) meet where
///
///     f(u) = rise² (near² - x²) + 2 drift rise h + flat² h² = 0,
///
/// a polynomial of twice the profile's degree. In Bernstein form its coefficients are the same combination of those of
/// x², y² and y, which are computed once for all rays. Their signs bound the number of roots (variation diminishing);
/// halving separates the roots, and Newton's method, kept in its bracket, finishes on the profile itself.
///
/// Two roots that f can hardly tell apart need another form. For a ray near the plane of rotation the two meetings, one
/// before the nearest point to the axis and one behind it, lie at nearly the same height, so f has nearly a double
/// root. But f is a product of two factors, flat h - rise r and flat h + rise r with r² = x² - near², and each has one
/// of the two as a simple root. For a ray near the axis the factors are x - d and x + d with d the line's distance from
/// the axis at that height.
///
/// Neighbouring segments judge their common end by the same numbers, so no line slips between them.
/// Tests: tests/03_bezier_surfaces/stability_roots.cpp holds it against subdivision that shares no code with it.
/// Source: Lane, Riesenfeld 1981, Bounds on a Polynomial; the factors are this course's.
class RevolvedSegment {
public:
    /// Of a profile; more is refused.
    static constexpr int highestDegree = 16;

    /// @param profile  of degree 1 to highestDegree; z is not used
    /// @throws InputError for another degree
    explicit RevolvedSegment(const BezierCurve& profile);

    /// More meetings than that can't be.
    static constexpr int mostRoots = 4 * highestDegree;

    /// What a search found.
    struct Roots {
        std::array<RevolvedRoot, mostRoots> root;
        int count = 0;

        /// Puts a root behind those of lower or the same u; beyond mostRoots it is dropped.
        void add(Real u, Real distance) {
            if (count >= mostRoots) return;
            auto place = static_cast<std::size_t>(count++);
            for (; place > 0 && root[place - 1].u > u; --place) root[place] = root[place - 1];
            root[place] = {u, distance};
        }
        /// For range-based loops.
        const RevolvedRoot* begin() const { return root.data(); }
        const RevolvedRoot* end() const { return root.data() + count; }
    };

    /// f in Bernstein form.
    struct Equation {
        std::array<Real, 2 * highestDegree + 1> coefficient;
        int degree;  ///< twice the profile's

        /// No coefficient is farther than that from its exact value for the numbers in the AxisRay. It grows with the
        /// terms that are added up, not with their sum: (16 + 2 degree) units of rounding, 2^-53 each, of the most that
        /// flat² h² + 2 |drift rise h| + rise² (near² + x²) can be, x and h as large as the control points allow, are
        /// enough; 100 (degree of the profile + 1) are too many.
        Real error;
    };

    /// The equation of a line's meetings.
    Equation equation(const AxisRay& ray) const;

    /// All meetings of the line with the segment, in the order of u. One that touches it, up to rounding, meets it
    /// nowhere or twice. One within the surface meets it everywhere: what is returned says nothing then, but takes
    /// no longer than for any other line. None for a line that is not finite.
    Roots roots(const AxisRay& ray) const;

    /// A piece of a line: from a distance along an AxisRay to another.
    struct Reach {
        Real from;
        Real to;
    };

    /// The piece of the line outside of which no meeting with the segment is: where it passes the segment's heights.
    /// Nothing when it passes outside of the cylinder of the segment's largest radius there.
    std::optional<Reach> reach(const AxisRay& ray) const;

    /// A point of the profile and its derivative by u.
    struct ProfilePoint {
        Vec2 position;
        Vec2 derivative;
    };

    /// The profile at u in [0, 1], by de Casteljau's algorithm; its ends are the first and the last control point
    /// exactly.
    ProfilePoint profileAt(Real u) const;

    /// Of the profile.
    int degree() const { return static_cast<int>(x_.size()) - 1; }

private:
    friend class RevolvedRootFinder;

    std::vector<Real> x_;        // control points' distance from the axis
    std::vector<Real> y_;        // control points' height
    std::vector<Real> xSquare_;  // Bernstein coefficients of x², of twice the degree
    std::vector<Real> ySquare_;  // of (y - middle_)²
    std::vector<Real> yRaised_;  // of y - middle_, raised to that degree
    Real middle_;                // a height within: y - middle_ is small, so that less cancels
    Real xLargest_;              // of |x|
    Real yLargest_;              // of |y - middle_|
    Real margin_;                // a millionth of the size: more than rounding can do
};

}  // namespace caustic
