#include "revolution_cases.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace caustic {

namespace {

constexpr Real turn = 2 * std::numbers::pi;

BezierCurve flat(const std::vector<Vec2>& points) {
    std::vector<Vec3> controlPoints;
    for (const Vec2& p : points) controlPoints.emplace_back(p.x(), p.y(), 0);
    return BezierCurve(std::move(controlPoints));
}

Vec3 onSphere(Random& random) {
    const Real z = random.uniform(-1, 1);
    const Real angle = random.uniform(0, turn);
    const Real r = std::sqrt(1 - z * z);
    return {r * std::cos(angle), r * std::sin(angle), z};
}

// A number whose order of magnitude is what is random: 1e-17 to 1, of either sign.
Real tiny(Random& random) {
    const Real magnitude = std::pow(10, -random.uniform(0, 17));
    return random.below(2) == 0 ? magnitude : -magnitude;
}

Real radiusOf(const SurfaceOfRevolution& surface) { return surface.bounds().diagonal().norm() / 2; }

Vec3 around(const SurfaceOfRevolution& surface, Random& random) {
    return surface.bounds().center() + 1.1 * radiusOf(surface) * onSphere(random);
}

Vec3 onSurface(const SurfaceOfRevolution& surface, Random& random) {
    return surface.evaluate(random.uniform(), random.uniform()).point;
}

Ray chord(const SurfaceOfRevolution& surface, Random& random) {
    const Vec3 from = around(surface, random);
    return {from, around(surface, random) - from};
}

Ray nearPlaneOfRotation(const SurfaceOfRevolution& surface, Random& random) {
    const Vec3 at = onSurface(surface, random);
    Vec3 from = around(surface, random);
    from.y() = at.y() + radiusOf(surface) * tiny(random);
    return {from, at - from};
}

Ray inPlaneOfRotation(const SurfaceOfRevolution& surface, Random& random) {
    const Vec3 at = onSurface(surface, random);
    Vec3 from = around(surface, random);
    from.y() = at.y();
    Vec3 way = at - from;
    way.y() = 0;
    return {from, way};
}

Ray nearlyParallelToAxis(const SurfaceOfRevolution& surface, Random& random) {
    const Vec3 at = onSurface(surface, random);
    const Real side = random.below(2) == 0 ? 2 : -2;
    const Vec3 from = at + radiusOf(surface) * Vec3(tiny(random), side, tiny(random));
    return {from, at - from};
}

Ray parallelToAxis(const SurfaceOfRevolution& surface, Random& random) {
    const Vec3 at = onSurface(surface, random);
    return {at - 3 * radiusOf(surface) * Vec3::UnitY(), Vec3::UnitY()};
}

Ray throughAxis(const SurfaceOfRevolution& surface, Random& random) {
    const Vec3 from = around(surface, random);
    const Real y = random.uniform(surface.bounds().min().y(), surface.bounds().max().y());
    return {from, Vec3(0, y, 0) - from};
}

Ray alongAxis(const SurfaceOfRevolution& surface, Random& random) {
    const Real height = 3 * radiusOf(surface);
    const Vec3 from = surface.bounds().center() + height * Vec3(0, random.below(2) == 0 ? 1 : -1, 0);
    const Vec3 offset = random.below(4) == 0 ? Vec3::Zero().eval() : Vec3(tiny(random), 0, tiny(random));
    return {from + radiusOf(surface) * offset, {0, from.y() > 0 ? -1.0 : 1.0, 0}};
}

Vec3 endOfSegment(const SurfaceOfRevolution& surface, Random& random) {
    const auto& profile = surface.profile();
    const BezierCurve& segment = profile[random.below(profile.size())];
    const Vec3 end = random.below(2) == 0 ? segment.controlPoints().front() : segment.controlPoints().back();
    const Real angle = random.uniform(0, turn);
    return {end.x() * std::cos(angle), end.y(), end.x() * std::sin(angle)};
}

Ray atJoint(const SurfaceOfRevolution& surface, Random& random) {
    const Vec3 at = endOfSegment(surface, random);
    const Vec3 from = around(surface, random);
    return {from, at - from};
}

Ray nearJoint(const SurfaceOfRevolution& surface, Random& random) {
    const Vec3 at = endOfSegment(surface, random) + 1e-9 * radiusOf(surface) * tiny(random) * onSphere(random);
    const Vec3 from = around(surface, random);
    return {from, at - from};
}

Ray atPole(const SurfaceOfRevolution& surface, Random& random) {
    const auto& profile = surface.profile();
    const Vec3 end =
        random.below(2) == 0 ? profile.front().controlPoints().front() : profile.back().controlPoints().back();
    const Vec3 at = Vec3(0, end.y(), 0) + radiusOf(surface) * Vec3(tiny(random), 0, tiny(random));
    const Vec3 from = around(surface, random);
    return {from, at - from};
}

Ray tangent(const SurfaceOfRevolution& surface, Random& random) {
    const SurfaceJet jet = surface.evaluate(random.uniform(), random.uniform());
    const Vec3 normal = jet.du.cross(jet.dv);
    const Real angle = random.uniform(0, turn);
    const Vec3 way = std::cos(angle) * jet.du.normalized() + std::sin(angle) * jet.dv.normalized();
    const Vec3 tilted = way + tiny(random) * normal.normalized();
    if (!tilted.allFinite()) return chord(surface, random);
    return {jet.point - 2 * radiusOf(surface) * tilted, tilted};
}

Ray fromAfar(const SurfaceOfRevolution& surface, Random& random) {
    const Vec3 from = 1e4 * around(surface, random);
    return {from, onSurface(surface, random) - from};
}

Ray fromSurface(const SurfaceOfRevolution& surface, Random& random) {
    return {onSurface(surface, random), onSphere(random)};
}

Ray betweenSurfacePoints(const SurfaceOfRevolution& surface, Random& random) {
    const Vec3 from = onSurface(surface, random);
    const Vec3 to = onSurface(surface, random);
    const Vec3 way = to - from;
    if (way.norm() == 0) return chord(surface, random);
    return {from - way, way};
}

Ray atRim(const SurfaceOfRevolution& surface, Random& random) {
    // The height that the profile has at one of its flat places, up to a little: where horizontal rays graze.
    const BezierCurve& segment = surface.profile()[random.below(surface.profile().size())];
    Real u = random.uniform();
    for (int i = 0; i < 40; ++i)
        u = std::clamp(u + Real(0.05) * (segment.derivative(u).y() > 0 ? 1 : -1) / (1 + i), Real(0), Real(1));
    Vec3 from = around(surface, random);
    from.y() = segment.position(u).y() + 1e-3 * radiusOf(surface) * tiny(random);
    const Vec3 to =
        surface.bounds().center() + radiusOf(surface) * Vec3(random.uniform(-1, 1), 0, random.uniform(-1, 1));
    return {from, Vec3(to.x() - from.x(), 1e-3 * radiusOf(surface) * tiny(random), to.z() - from.z())};
}

}  // namespace

std::vector<BezierCurve> plainVase() {
    return {flat({{0, 0}, {0.3, 0}, {0.6, 0}, {0.6, 0.1}}), flat({{0.6, 0.1}, {0.6, 0.5}, {0.15, 0.6}, {0.2, 1}}),
            flat({{0.2, 1}, {0.25, 1.3}, {0.8, 1.2}, {0.7, 1.6}}),
            flat({{0.7, 1.6}, {0.65, 1.8}, {0.4, 1.9}, {0.45, 2}})};
}

std::vector<NamedProfile> difficultProfiles() {
    return {
        {"vase", plainVase()},
        {"degree 12",
         {flat({{0, -1},
                {1.6, -1},
                {-0.4, -0.6},
                {1.9, -0.8},
                {0.1, -0.2},
                {1.4, -0.3},
                {0.2, 0.3},
                {2.1, 0.1},
                {-0.7, 0.5},
                {1.8, 0.4},
                {0.3, 0.9},
                {0.9, 0.7},
                {0, 1}})}},
        {"cusp",
         {flat({{0, -1}, {1.2, -1}, {1.2, -0.2}, {0.6, 0}}), flat({{0.6, 0}, {2, 0.6}, {0, 0.6}, {1.4, 0}}),
          flat({{1.4, 0}, {0.5, 0.8}, {1.5, 1.4}, {0, 1}})}},
        {"negative radius", {flat({{0.8, -1}, {-1.4, -0.5}, {1.6, 0.6}, {-0.5, 1}})}},
        {"cone and disc", {flat({{0, -0.5}, {1, -0.5}}), flat({{1, -0.5}, {0, 1}})}},
        {"touches the axis", {flat({{1, -1}, {-1.0 / 3, -1.0 / 3}, {-1.0 / 3, 1.0 / 3}, {1, 1}})}},
        {"coincident points", {flat({{0, 0}, {1, 0}, {1, 0}, {1, 1}}), flat({{1, 1}, {1, 1}, {0.5, 1}, {0, 1}})}},
        {"thin wall",
         {flat({{0, 0}, {0.8, 0}, {1, 0.3}, {1, 1}}), flat({{1, 1}, {1, 1.0005}, {0.999, 1.0005}, {0.999, 1}}),
          flat({{0.999, 1}, {0.999, 0.301}, {0.799, 0.001}, {0, 0.001}})}},
    };
}

std::vector<RaySet> revolutionRaySets() {
    return {
        {"random chords", chord},
        {"near the plane of rotation", nearPlaneOfRotation},
        {"in the plane of rotation", inPlaneOfRotation},
        {"nearly parallel to the axis", nearlyParallelToAxis},
        {"parallel to the axis", parallelToAxis},
        {"through the axis", throughAxis},
        {"along the axis", alongAxis},
        {"at the profile's joints", atJoint},
        {"just beside the joints", nearJoint},
        {"at the poles", atPole},
        {"tangent", tangent},
        {"from afar", fromAfar},
        {"from the surface", fromSurface},
        {"through two surface points", betweenSurfacePoints},
        {"at rims and flat places", atRim},
    };
}

}  // namespace caustic
