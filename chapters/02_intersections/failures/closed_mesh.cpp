#include "failures/closed_mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

#include "leaving.h"
#include "math/transform.h"

namespace caustic {

namespace {

using Triangles = std::vector<std::array<int, 3>>;

// Unit vectors to the icosahedron's corners, and its 20 faces.
ClosedMesh icosahedron() {
    constexpr Real golden = std::numbers::phi;
    ClosedMesh mesh;
    for (const Real a : {-1.0, 1.0}) {
        for (const Real b : {-golden, golden}) {
            mesh.vertices.push_back(Vec3(0, a, b).normalized());
            mesh.vertices.push_back(Vec3(a, b, 0).normalized());
            mesh.vertices.push_back(Vec3(b, 0, a).normalized());
        }
    }
    // Three corners make a face when they are neighbours of each other: 1.0515 apart, while others are 1.7 or more.
    const auto close = [&](int i, int j) {
        return (mesh.vertices[static_cast<std::size_t>(i)] - mesh.vertices[static_cast<std::size_t>(j)]).norm() < 1.2;
    };
    for (int i = 0; i < 12; ++i) {
        for (int j = i + 1; j < 12; ++j) {
            for (int k = j + 1; k < 12; ++k) {
                if (!close(i, j) || !close(j, k) || !close(i, k)) continue;
                const auto [a, b, c] =
                    std::array{mesh.vertices[static_cast<std::size_t>(i)], mesh.vertices[static_cast<std::size_t>(j)],
                               mesh.vertices[static_cast<std::size_t>(k)]};
                const bool outwards = (b - a).cross(c - a).dot(a) > 0;
                mesh.triangles.push_back(outwards ? std::array{i, j, k} : std::array{i, k, j});
            }
        }
    }
    return mesh;
}

// Each triangle becomes four; the new corners go to the unit sphere.
void subdivide(ClosedMesh& mesh) {
    std::map<std::array<int, 2>, int> middles;
    const auto middle = [&](int i, int j) {
        const auto [found, isNew] =
            middles.try_emplace({std::min(i, j), std::max(i, j)}, static_cast<int>(mesh.vertices.size()));
        if (isNew) {
            const Vec3 sum = mesh.vertices[static_cast<std::size_t>(i)] + mesh.vertices[static_cast<std::size_t>(j)];
            mesh.vertices.push_back(sum.normalized());
        }
        return found->second;
    };
    Triangles finer;
    for (const auto& [a, b, c] : mesh.triangles) {
        const int ab = middle(a, b);
        const int bc = middle(b, c);
        const int ca = middle(c, a);
        finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    mesh.triangles = std::move(finer);
}

void findNeighbours(ClosedMesh& mesh) {
    std::map<std::array<int, 2>, std::vector<int>> trianglesOfEdge;
    mesh.trianglesOfVertex.resize(mesh.vertices.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const int i = mesh.triangles[t][corner];
            const int j = mesh.triangles[t][(corner + 1) % 3];
            trianglesOfEdge[{std::min(i, j), std::max(i, j)}].push_back(static_cast<int>(t));
            mesh.trianglesOfVertex[static_cast<std::size_t>(i)].push_back(static_cast<int>(t));
        }
    }
    for (const auto& [edge, triangles] : trianglesOfEdge) {
        mesh.edges.push_back(edge);
        mesh.trianglesOfEdge.push_back({triangles.at(0), triangles.at(1)});
    }
}

// Distance from the origin to the nearest plane of a face: the mesh is star-shaped, so a ball of it is inside.
Real ballInside(const ClosedMesh& mesh) {
    Real least = std::numeric_limits<Real>::infinity();
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto [a, b, c] = mesh.corners(static_cast<int>(t));
        least = std::min(least, (b - a).cross(c - a).normalized().dot(a));
    }
    return least;
}

Transform randomPlace(Random& random, std::optional<Real> away) {
    const auto turn = [&] { return Transform::rotation(randomDirection(random), random.uniform(0, 6)); };
    const Vec3 factors(1, std::pow(10, random.uniform(-0.5, 0.5)), std::pow(10, random.uniform(-0.5, 0.5)));
    const Real distance = std::pow(10, random.uniform(-2, 2));
    const Vec3 place = away.value_or(distance) * randomDirection(random);
    return Transform::translation(place) * turn() * Transform::scaling(factors) * turn();
}

}  // namespace

std::array<Vec3, 3> ClosedMesh::corners(int triangle) const {
    const auto [a, b, c] = triangles[static_cast<std::size_t>(triangle)];
    return {vertices[static_cast<std::size_t>(a)], vertices[static_cast<std::size_t>(b)],
            vertices[static_cast<std::size_t>(c)]};
}

Vec3 ClosedMesh::pointInside(Random& random) const {
    const Vec3 p = randomInBall(random);
    return center + p.x() * insideAxes[0] + p.y() * insideAxes[1] + p.z() * insideAxes[2];
}

ClosedMesh randomClosedMesh(Random& random, std::optional<Real> away) {
    static const ClosedMesh smooth = [] {
        ClosedMesh mesh = icosahedron();
        subdivide(mesh);
        findNeighbours(mesh);
        return mesh;
    }();
    ClosedMesh mesh = smooth;
    for (Vec3& vertex : mesh.vertices) vertex *= random.uniform(0.7, 1.3);
    const Transform place = randomPlace(random, away);
    const Real radius = 0.9 * ballInside(mesh);
    mesh.center = place.translation();
    for (int axis = 0; axis < 3; ++axis) {
        mesh.insideAxes[static_cast<std::size_t>(axis)] = place.vector(radius * Vec3::Unit(axis));
    }
    for (Vec3& vertex : mesh.vertices) vertex = place.point(vertex);
    return mesh;
}

}  // namespace caustic
