#include "curve/svg_arc.h"
#include "math/stable_norm.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace caustic {

namespace {

constexpr Real widestPiece = std::numbers::pi / 4;

Vec2 turned(const Vec2& v) { return {-v.y(), v.x()}; }

// The arc seen where its ellipse is the unit circle around the origin.
struct CircleArc {
    Real start;  // angle of its beginning
    Real turn;   // signed angle to its end
};

// Half the chord, seen there, decides: longer than 1 it doesn't fit in, and the radii are scaled by its length.
CircleArc arcOnCircle(const Vec2& halfChord, Real length, const SvgArc& arc) {
    const Real half = std::min(length, Real(1));
    const Real aside = std::sqrt((1 - half) * (1 + half));  // distance of the chord from the centre
    const Vec2 along = halfChord / length;
    // From the chord's middle, the centre lies to the left for exactly one of "large" and "sweep".
    const Real side = arc.large != arc.sweep ? 1 : -1;
    const Vec2 start = -half * along - side * aside * turned(along);
    const Real small = 2 * std::atan2(half, aside);
    const Real angle = arc.large ? 2 * std::numbers::pi - small : small;
    return {std::atan2(start.y(), start.x()), arc.sweep ? angle : -angle};
}

}  // namespace

std::vector<CubicPiece> arcToCubics(const SvgArc& arc) {
    if (arc.from == arc.to) return {};
    const Eigen::Rotation2D<Real> rotation(std::remainder(arc.rotation, Real(360)) * std::numbers::pi / 180);
    const Vec2 halfChord = (rotation.inverse() * Vec2(arc.to / 2 - arc.from / 2)).cwiseQuotient(arc.radii.cwiseAbs());
    const Real length = stableNorm(halfChord);
    // Not finite: a radius is zero, or so small that the arc is one. Zero: the ends are as good as equal.
    if (!std::isfinite(length) || length == 0) return {lineToCubic(arc.from, arc.to)};

    const Vec2 radii = arc.radii.cwiseAbs() * std::max(length, Real(1));
    const auto [start, turn] = arcOnCircle(halfChord, length, arc);
    const auto onPage = [&](const Vec2& v) -> Vec2 { return rotation * Vec2(radii.cwiseProduct(v)); };
    const auto onCircle = [](Real angle) -> Vec2 { return {std::cos(angle), std::sin(angle)}; };

    const int count = std::max(1, static_cast<int>(std::ceil(std::abs(turn) / widestPiece - 1e-9)));
    const Real step = turn / count;
    const Real reach = Real(4) / 3 * std::tan(step / 4);
    std::vector<CubicPiece> pieces;
    Vec2 from = arc.from;
    for (int i = 0; i < count; ++i) {
        const Vec2 begin = onCircle(start + i * step);
        const Vec2 end = onCircle(start + (i + 1) * step);
        // Relative to the given ends, not to the centre: that is far away when a huge radius makes a flat arc.
        const Vec2 to = i + 1 == count ? arc.to : Vec2(from + onPage(end - begin));
        pieces.push_back({from + onPage(reach * turned(begin)), to - onPage(reach * turned(end)), to});
        from = to;
    }
    return pieces;
}

CubicPiece lineToCubic(const Vec2& from, const Vec2& to) {
    const Vec2 third = to / 3 - from / 3;
    return {from + third, to - third, to};
}

CubicPiece quadraticToCubic(const Vec2& from, const Vec2& control, const Vec2& to) {
    return {from + (control - from) * (Real(2) / 3), to + (control - to) * (Real(2) / 3), to};
}

}  // namespace caustic
