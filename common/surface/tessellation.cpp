#include "surface/tessellation.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/check.h"

namespace caustic {

namespace {

constexpr Real mostTriangles = 1 << 24;
constexpr Real turn = 2 * std::numbers::pi;

void checkCount(Real triangles, Real tolerance) {
    checkArgument(triangles <= mostTriangles, "tessellation's tolerance", formatReal(tolerance),
                  "is too small: it takes more than 2^24 triangles");
}

void addQuad(IndexedTriangles& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    if (a != b && b != c) mesh.triangles.push_back({a, b, c});
    if (c != d && d != a) mesh.triangles.push_back({a, c, d});
}

std::uint32_t addVertex(IndexedTriangles& mesh, const Vec3& vertex) {
    mesh.vertices.push_back(vertex);
    return static_cast<std::uint32_t>(mesh.vertices.size() - 1);
}

// Chords of the profile within the tolerance.
int chordsOf(const BezierCurve& curve, Real tolerance) {
    const auto& points = curve.controlPoints();
    Real bend = 0;
    for (std::size_t i = 2; i < points.size(); ++i) {
        bend = std::max(bend, (points[i] - 2 * points[i - 1] + points[i - 2]).head<2>().norm());
    }
    bend *= curve.degree() * (curve.degree() - 1);
    const Real chords = std::max(Real(1), std::ceil(std::sqrt(bend / (8 * tolerance))));
    checkCount(chords, tolerance);
    return static_cast<int>(chords);
}

// Vertices around the axis at one place of the profile; a single one, many times over, on the axis itself.
std::vector<std::uint32_t> addRing(IndexedTriangles& mesh, const Vec3& at, int around) {
    std::vector<std::uint32_t> ring;
    for (int j = 0; j < around; ++j) {
        if (at.x() == 0 && j > 0) {
            ring.push_back(ring.front());
            continue;
        }
        const Real angle = turn * j / around;
        ring.push_back(addVertex(mesh, {at.x() * std::cos(angle), at.y(), at.x() * std::sin(angle)}));
    }
    return ring;
}

}  // namespace

IndexedTriangles tessellated(const SurfaceOfRevolution& surface, Real tolerance) {
    checkPositive(tolerance, "tessellation's tolerance");
    const Real radius = surface.bounds().max().x();
    // The polygon's sagitta, radius (1 - cos(π / n)), takes half of the tolerance.
    const Real half = std::acos(std::max(Real(0), 1 - tolerance / (2 * radius)));
    const Real sides = std::max(Real(3), std::ceil(std::numbers::pi / half));
    Real chords = 0;
    for (const BezierCurve& segment : surface.profile()) chords += chordsOf(segment, tolerance / 2);
    checkCount(2 * sides * chords, tolerance);

    IndexedTriangles mesh;
    const int around = static_cast<int>(sides);
    std::vector<std::uint32_t> before;
    Vec3 endBefore = Vec3::Constant(std::nan(""));
    for (const BezierCurve& segment : surface.profile()) {
        if (segment.controlPoints().front() != endBefore)
            before = addRing(mesh, segment.controlPoints().front(), around);
        const int pieces = chordsOf(segment, tolerance / 2);
        for (int i = 1; i <= pieces; ++i) {
            const Vec3 at = i == pieces ? segment.controlPoints().back() : segment.position(Real(i) / pieces);
            const std::vector<std::uint32_t> ring = addRing(mesh, at, around);
            for (std::size_t j = 0; j < ring.size(); ++j) {
                const std::size_t next = (j + 1) % ring.size();
                addQuad(mesh, before[j], ring[j], ring[next], before[next]);
            }
            before = ring;
        }
        endBefore = segment.controlPoints().back();
    }
    return mesh;
}

}  // namespace caustic
