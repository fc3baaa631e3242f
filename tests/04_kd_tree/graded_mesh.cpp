#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "mesh/obj_file.h"
#include "mesh/triangle_clip.h"
#include "mesh/triangle_mesh.h"
#include "mesh/vertex_normals.h"
#include "support/in_cube.h"

namespace caustic {
namespace {

using test::inCube;

// All corners of what is in both, whichever way round: the triangle's corners, where its edges cross the cell's faces,
// and where the cell's edges cross the triangle. No polygon is cut.
Bounds3 cornersInBoth(const std::array<Vec3, 3>& triangle, const Bounds3& cell) {
    const Vec3 rounding = 1e-9 * cell.sizes();
    const Bounds3 padded(cell.min() - rounding, cell.max() + rounding);
    Bounds3 found;
    const auto take = [&](const Vec3& point) {
        if (padded.contains(point)) found.extend(point);
    };
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3& from = triangle[i];
        const Vec3 way = triangle[(i + 1) % 3] - from;
        take(from);
        for (int axis = 0; axis < 3; ++axis) {
            for (const Real face : {cell.min()[axis], cell.max()[axis]}) {
                const Real t = (face - from[axis]) / way[axis];
                if (t >= 0 && t <= 1) take(from + t * way);
            }
        }
    }
    const Vec3 u = triangle[1] - triangle[0];
    const Vec3 v = triangle[2] - triangle[0];
    const Vec3 normal = u.cross(v);
    for (int axis = 0; axis < 3; ++axis) {
        for (int corner = 0; corner < 4; ++corner) {
            Vec3 from = cell.min();
            if ((corner & 1) != 0) from[(axis + 1) % 3] = cell.max()[(axis + 1) % 3];
            if ((corner & 2) != 0) from[(axis + 2) % 3] = cell.max()[(axis + 2) % 3];
            from[axis] += normal.dot(triangle[0] - from) / normal[axis];
            const Vec3 inside = from - triangle[0];
            const Real b1 = inside.cross(v).dot(normal) / normal.squaredNorm();
            const Real b2 = u.cross(inside).dot(normal) / normal.squaredNorm();
            if (b1 >= -1e-9 && b2 >= -1e-9 && b1 + b2 <= 1 + 1e-9) take(from);
        }
    }
    return found;
}

// Every point of the triangle that is in the cell must be in the box, sampled densely; and the box is as tight as the
// corners of what is in both, and never reaches out of the cell.
TEST(TriangleClip, HoldsAllThatIsInTheCellAndNoMore) {
    int some = 0;
    for (std::uint64_t i = 0; i < 4000; ++i) {
        Random random(2, {i});
        const Real scale = std::array<Real, 3>{1, 1e-6, 1e6}[i % 3];
        const Vec3 far = i % 2 == 0 ? Vec3(0.3, -0.2, 0.1) : Vec3(-20, 7, 30);
        const auto placed = [&](const Vec3& p) -> Vec3 { return scale * (p + far); };
        const std::array<Vec3, 3> corners = {placed(2 * inCube(random)), placed(2 * inCube(random)),
                                             placed(2 * inCube(random))};
        const Vec3 center = inCube(random);
        const Bounds3 cell(placed(center - Vec3(0.4, 0.5, 0.6)), placed(center + Vec3(0.6, 0.5, 0.4)));
        const Bounds3 box = clippedTriangleBounds(corners[0], corners[1], corners[2], cell);
        ASSERT_TRUE(box.isEmpty() || cell.contains(box)) << "May it be larger than the cell, by rounding?";
        const Vec3 rounding = Vec3::Constant(scale * 1e-11);
        const Bounds3 padded = box.isEmpty() ? box : Bounds3(box.min() - rounding, box.max() + rounding);
        for (int k = 0; k < 30; ++k) {
            const Real size = std::sqrt(random.uniform());
            const Real share = random.uniform();
            const Vec3 point = (1 - size) * corners[0] + size * (1 - share) * corners[1] + size * share * corners[2];
            ASSERT_TRUE(!cell.contains(point) || padded.contains(point))
                << "Which plane cuts off a part that is inside?";
        }
        const Bounds3 expected = cornersInBoth(corners, cell);
        if (expected.isEmpty() || expected.sizes().maxCoeff() < 1e-6 * scale) continue;  // it may just touch the cell
        ++some;
        const Real off = std::max((box.min() - expected.min()).cwiseAbs().maxCoeff(),
                                  (box.max() - expected.max()).cwiseAbs().maxCoeff());
        ASSERT_LT(off, 1e-6 * scale) << "triangle " << i << ": are all six faces of the cell cut off, and only the "
                                     << "corners kept that the polygon has in the end?";
    }
    ASSERT_GT(some, 1000);
}

// The triangle x + y + z = 1, by hand: beyond its edges, and on one side of its plane.
TEST(TriangleClip, IsEmptyBesideTheTriangle) {
    for (const Real size : {1.0, 1e-6, 1e6}) {
        const Vec3 a = size * Vec3::UnitX();
        const Vec3 b = size * Vec3::UnitY();
        const Vec3 c = size * Vec3::UnitZ();
        const Bounds3 part = clippedTriangleBounds(a, b, c, Bounds3(size * Vec3(0.5, 0, 0), size * Vec3::Ones()));
        EXPECT_TRUE((part.min() / size).isApprox(Vec3(0.5, 0, 0), 1e-14)) << part.min().transpose();
        EXPECT_TRUE((part.max() / size).isApprox(Vec3(1, 0.5, 0.5), 1e-14))
            << part.max().transpose() << ": beyond x = 0.5 neither y nor z exceeds 0.5.";
        for (const Real side : {0.4, -0.1}) {
            const Vec3 low = size * Vec3::Constant(side);
            const Bounds3 beside = clippedTriangleBounds(a, b, c, Bounds3(low, low + size * Vec3::Constant(0.3)));
            EXPECT_TRUE(beside.isEmpty()) << "The cell is in the triangle's box, but on one side of its plane.";
        }
        const Bounds3 away = clippedTriangleBounds(a, b, c, Bounds3(size * Vec3(0.6, 0.6, -1), size * Vec3(2, 2, 2)));
        EXPECT_TRUE(away.isEmpty()) << "The cell is beyond the triangle's edge.";
    }
}

// One triangle in a plane, normals that differ: at the corners they are what the mesh says.
MeshData oneTriangle() {
    MeshData mesh;
    mesh.positions = {Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(0, 2, 0)};
    mesh.triangles = {{0, 1, 2}};
    mesh.normals = {Vec3(0.6, 0, 0.8), Vec3(0, 0, 5), Vec3(0, 0.6, 0.8)};
    mesh.normalCorners = {{0, 1, 2}};
    return mesh;
}

TEST(InterpolatedNormal, IsTheCornersNormalsByBarycentricCoordinates) {
    const MeshData mesh = oneTriangle();
    const Vec3 ng = Vec3::UnitZ();
    EXPECT_TRUE(interpolatedNormal(mesh, {{1, 0, 0}, 0}, ng).isApprox(Vec3(0.6, 0, 0.8), 1e-14))
        << "At b1 = b2 = 0 stands the first corner.";
    EXPECT_TRUE(interpolatedNormal(mesh, {{1, 1, 0}, 0}, ng).isApprox(Vec3::UnitZ(), 1e-14)) << "b1 is the second's.";
    EXPECT_TRUE(interpolatedNormal(mesh, {{1, 0, 1}, 0}, ng).isApprox(Vec3(0, 0.6, 0.8), 1e-14))
        << "b2 is the third's.";
    const Vec3 middle = interpolatedNormal(mesh, {{1, 0.5, 0.25}, 0}, ng);
    const Vec3 expected = (0.25 * Vec3(0.6, 0, 0.8) + 0.5 * Vec3::UnitZ() + 0.25 * Vec3(0, 0.6, 0.8)).normalized();
    EXPECT_TRUE(middle.isApprox(expected, 1e-14))
        << "A file's normals may have any length: are they made unit ones before they are mixed, and the sum after?";

    // The second of two triangles, whose corners name normals in an order of their own, of lengths far apart.
    MeshData several = oneTriangle();
    several.triangles = {{0, 1, 2}, {2, 1, 0}};
    several.normalCorners = {{1, 1, 1}, {3, 0, 2}};
    const std::array<Vec3, 3> unit = {Vec3(0.48, 0.64, 0.6), Vec3(-0.6, 0, 0.8), Vec3(0.28, -0.96, 0)};
    for (const Real length : {1.0, 1e-6, 1e6}) {
        several.normals = {length * unit[1], Vec3::UnitX(), unit[2] / length, 7 * unit[0]};
        for (const Vec2& b : {Vec2(0.2, 0.3), Vec2(0.7, 0.1), Vec2(0, 0.4)}) {
            const Vec3 mixed = ((1 - b.x() - b.y()) * unit[0] + b.x() * unit[1] + b.y() * unit[2]).normalized();
            EXPECT_TRUE(interpolatedNormal(several, {{1, b.x(), b.y()}, 1}, Vec3(0.6, 0, 0.8)).isApprox(mixed, 1e-13))
                << "Lengths " << length << ": which list do a triangle's normals come from, and by which numbers?";
        }
    }
}

TEST(InterpolatedNormal, StaysOnTheFacesSideAndFallsBackToIt) {
    MeshData mesh = oneTriangle();
    const Vec3 front = interpolatedNormal(mesh, {{1, 0.3, 0.3}, 0}, Vec3::UnitZ());
    const Vec3 back = interpolatedNormal(mesh, {{1, 0.3, 0.3}, 0}, -Vec3::UnitZ());
    EXPECT_GT(front.z(), 0);
    EXPECT_EQ(back, -front) << "ns is on the side of ng.";
    for (int octant = 0; octant < 8; ++octant) {
        const Vec3 ng(octant & 1 ? -0.36 : 0.36, octant & 2 ? -0.48 : 0.48, octant & 4 ? -0.8 : 0.8);
        mesh = oneTriangle();
        const Vec3 smooth = interpolatedNormal(mesh, {{1, 0.3, 0.3}, 0}, ng);
        EXPECT_EQ(smooth, ng.dot(front) < 0 ? back : front) << "Seen from " << ng.transpose();
        mesh.normals[1] = Vec3::Zero();
        EXPECT_EQ(interpolatedNormal(mesh, {{1, 0.3, 0.3}, 0}, ng), ng) << "A corner has no normal.";
        mesh.normals = {Vec3::UnitX(), -Vec3::UnitX(), Vec3::UnitX()};
        EXPECT_EQ(interpolatedNormal(mesh, {{1, 0.5, 0}, 0}, ng), ng) << "The normals cancel.";
        for (std::size_t corner = 0; corner < 3; ++corner) {
            mesh = oneTriangle();
            mesh.normalCorners[0][corner] = MeshData::none;
            EXPECT_EQ(interpolatedNormal(mesh, {{1, 0.3, 0.3}, 0}, ng), ng) << "A corner names none.";
        }
        MeshData bare;
        bare.positions = mesh.positions;
        bare.triangles = mesh.triangles;
        EXPECT_EQ(interpolatedNormal(bare, {{1, 0.3, 0.3}, 0}, ng), ng) << "The mesh has none.";
    }
}

// A pyramid's corner: three faces, of which one is cut into two. Unit normals of the three planes are the axes.
MeshData cornerOfABox(const Vec3& size) {
    MeshData mesh;
    mesh.positions = {Vec3::Zero(), Vec3(size.x(), 0, 0), Vec3(0, size.y(), 0), Vec3(0, 0, size.z()),
                      Vec3(size.x(), size.y(), 0)};
    // Outside is towards negative coordinates; z = 0 is cut in two at the corner.
    mesh.triangles = {{0, 4, 1}, {0, 2, 4}, {0, 3, 2}, {0, 1, 3}};
    return mesh;
}

// A crumpled sheet somewhere: each vertex against the sum over all triangles that name it, each with its weight.
template <typename Weight>
void expectSumOverTriangles(NormalWeight weight, const Weight& weightOf) {
    for (const Real scale : {1.0, 1e-6, 1e6}) {
        Random random(8, {});
        MeshData mesh;
        for (int i = 0; i < 9; ++i) mesh.positions.push_back(scale * (Vec3(i / 3, i % 3, 0) + 0.4 * inCube(random)));
        for (Vec3& position : mesh.positions) position += scale * Vec3(5, -3, 8);
        for (const std::uint32_t i : {0U, 1U, 3U, 4U}) {
            mesh.triangles.push_back({i, i + 3, i + 4});
            mesh.triangles.push_back({i + 4, i + 1, i});
        }
        const auto normals = vertexNormals(mesh, weight);
        for (std::uint32_t vertex = 0; vertex < 9; ++vertex) {
            Vec3 sum = Vec3::Zero();
            for (const auto& triangle : mesh.triangles) {
                for (std::size_t i = 0; i < 3; ++i) {
                    if (triangle[i] != vertex) continue;
                    const Vec3 next = (mesh.positions[triangle[(i + 1) % 3]] - mesh.positions[vertex]) / scale;
                    const Vec3 last = (mesh.positions[triangle[(i + 2) % 3]] - mesh.positions[vertex]) / scale;
                    sum += weightOf(next, last) * next.cross(last).normalized();
                }
            }
            EXPECT_TRUE(normals[vertex].isApprox(sum.normalized(), 1e-11))
                << "vertex " << vertex << ", scale " << scale << ": what does each of its triangles add, and how much?";
        }
    }
}

TEST(VertexNormals, MeanTakesEachTriangleOnce) {
    const Vec3 normal = vertexNormals(cornerOfABox(Vec3(1, 2, 3)), NormalWeight::Mean)[0];
    EXPECT_TRUE(normal.isApprox(Vec3(-1, -1, -2).normalized(), 1e-14))
        << normal.transpose() << ": two triangles look along -z. Does each count with a unit normal?";
    expectSumOverTriangles(NormalWeight::Mean, [](const Vec3&, const Vec3&) { return 1; });
}

TEST(VertexNormals, AreaTakesLargeTrianglesMore) {
    const Vec3 normal = vertexNormals(cornerOfABox(Vec3(1, 2, 3)), NormalWeight::Area)[0];
    // x = 0: half of 2 · 3; y = 0: half of 1 · 3; z = 0: two halves of 1 · 2.
    EXPECT_TRUE(normal.isApprox(-Vec3(3, 1.5, 2).normalized(), 1e-14)) << normal.transpose();
    expectSumOverTriangles(NormalWeight::Area, [](const Vec3& a, const Vec3& b) { return a.cross(b).norm(); });
}

TEST(VertexNormals, AngleDoesNotSeeHowAFaceIsCut) {
    const Vec3 normal = vertexNormals(cornerOfABox(Vec3(1, 2, 3)), NormalWeight::Angle)[0];
    EXPECT_TRUE(normal.isApprox(-Vec3(1, 1, 1).normalized(), 1e-14))
        << normal.transpose() << ": three right angles meet. Is the angle the one at this vertex?";
    expectSumOverTriangles(NormalWeight::Angle,
                           [](const Vec3& a, const Vec3& b) { return std::acos(a.normalized().dot(b.normalized())); });
}

TEST(VertexNormals, NothingComesFromTrianglesWithoutArea) {
    MeshData mesh = cornerOfABox(Vec3::Ones());
    mesh.positions.push_back(Vec3(7, 7, 7));  // of no triangle
    mesh.triangles.push_back({0, 1, 1});
    for (const NormalWeight weight : {NormalWeight::Mean, NormalWeight::Area, NormalWeight::Angle}) {
        const auto normals = vertexNormals(mesh, weight);
        ASSERT_EQ(normals.size(), 6U);
        EXPECT_EQ(normals[5], Vec3::Zero()) << "A vertex without triangles has no normal.";
        EXPECT_TRUE(normals[0].allFinite()) << "What is 0 / 0?";
        EXPECT_NEAR(normals[0].norm(), 1, 1e-14);
    }
}

// As in the OBJ specification: 1 is the first, -1 the latest.
TEST(ObjIndex, CountsFromBothEnds) {
    EXPECT_EQ(objIndex(1, 5), 0U) << "OBJ counts from 1.";
    EXPECT_EQ(objIndex(5, 5), 4U);
    EXPECT_EQ(objIndex(-1, 5), 4U) << "-1 is the latest one.";
    EXPECT_EQ(objIndex(-5, 5), 0U);
    EXPECT_EQ(objIndex(7, 5), 6U) << "A face may come before its vertices.";
    EXPECT_EQ(objIndex(4'294'967'294LL, 5), 4'294'967'293U) << "The last one that is told from MeshData::none.";
}

TEST(ObjIndex, RefusesWhatNamesNothing) {
    EXPECT_EQ(objIndex(0, 5), std::nullopt) << "There is no 0.";
    EXPECT_EQ(objIndex(-6, 5), std::nullopt) << "That is before the first one.";
    EXPECT_EQ(objIndex(-1, 0), std::nullopt);
    EXPECT_EQ(objIndex(4'294'967'295LL, 5), std::nullopt) << "Which index is MeshData::none?";
    EXPECT_EQ(objIndex(5'000'000'000LL, 5), std::nullopt) << "That does not fit into 32 bits.";
}

}  // namespace
}  // namespace caustic
