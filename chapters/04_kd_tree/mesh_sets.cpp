#include "mesh_sets.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace caustic {

namespace {

Vec3 inCube(Random& random) {
    const Real x = random.uniform(-1, 1);
    const Real y = random.uniform(-1, 1);
    return {x, y, random.uniform(-1, 1)};
}

void add(MeshData& mesh, const Vec3& a, const Vec3& b, const Vec3& c) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), {a, b, c});
    mesh.triangles.push_back({first, first + 1, first + 2});
}

void addSmall(MeshData& mesh, Random& random, Real size) {
    const Vec3 a = inCube(random);
    const Vec3 b = a + size * inCube(random);
    add(mesh, a, b, a + size * inCube(random));
}

MeshData anywhere(Random& random, std::uint32_t triangles) {
    MeshData mesh;
    for (std::uint32_t i = 0; i < triangles; ++i) addSmall(mesh, random, 0.2);
    return mesh;
}

MeshData inOnePlane(Random& random, std::uint32_t triangles) {
    MeshData mesh = anywhere(random, triangles);
    for (Vec3& position : mesh.positions) position.y() = 0.3;
    return mesh;
}

// Each triangle has three corners of the cube, and touches all six faces.
MeshData identicalBoxes(Random& random, std::uint32_t triangles) {
    MeshData mesh;
    for (std::uint32_t i = 0; i < triangles; ++i) {
        const auto sign = [&] { return random.below(2) == 0 ? 1.0 : -1.0; };
        const Vec3 corner(sign(), sign(), sign());
        Vec3 middle = -corner;
        middle[static_cast<int>(random.below(3))] *= -random.uniform(0, 1);
        add(mesh, corner, -corner, middle);
    }
    return mesh;
}

MeshData oneHuge(Random& random, std::uint32_t triangles) {
    MeshData mesh;
    add(mesh, Vec3(-1000, -1000, -900), Vec3(1000, -1000, -1000), Vec3(0, 1000, 1000));
    for (std::uint32_t i = 1; i < triangles; ++i) addSmall(mesh, random, 0.05);
    return mesh;
}

MeshData slivers(Random& random, std::uint32_t triangles) {
    MeshData mesh;
    for (std::uint32_t i = 0; i < triangles; ++i) {
        const Vec3 a = inCube(random);
        const Vec3 along = inCube(random);
        add(mesh, a, a + along, a + 1.0001 * along + 1e-6 * inCube(random));
    }
    return mesh;
}

MeshData eachTwice(Random& random, std::uint32_t triangles) {
    MeshData mesh = anywhere(random, triangles / 2);
    const std::vector<MeshData::Corners> once = mesh.triangles;
    mesh.triangles.insert(mesh.triangles.end(), once.begin(), once.end());
    return mesh;
}

MeshData onGrid(Random& random, std::uint32_t triangles) {
    MeshData mesh = anywhere(random, triangles);
    for (Vec3& position : mesh.positions) position = (8 * position).array().round() / 8;
    return mesh;
}

MeshData farAway(Random& random, std::uint32_t triangles) {
    MeshData mesh = anywhere(random, triangles);
    for (Vec3& position : mesh.positions) position = 1e-3 * position + Vec3(1000, 2000, -500);
    return mesh;
}

}  // namespace

std::vector<MeshSet> meshSets() {
    return {{"anywhere", anywhere},           {"in one plane", inOnePlane}, {"in identical boxes", identicalBoxes},
            {"one huge among tiny", oneHuge}, {"slivers", slivers},         {"each triangle twice", eachTwice},
            {"corners on a grid", onGrid},    {"far away", farAway}};
}

MeshData bumpySphere(std::uint32_t triangles) {
    const auto rows = static_cast<std::uint32_t>(std::max(2.0, std::floor(std::sqrt(triangles / 4.0))));
    const std::uint32_t columns = std::max(3U, triangles / (2 * rows));
    MeshData mesh;
    for (std::uint32_t row = 0; row <= rows; ++row) {
        for (std::uint32_t column = 0; column <= columns; ++column) {
            const Real theta = std::numbers::pi * row / rows;
            const Real phi = 2 * std::numbers::pi * column / columns;
            const Real radius = 1 + 0.1 * std::sin(5 * theta) * std::sin(7 * phi);
            const Vec3 unit(std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi));
            mesh.positions.push_back(radius * unit);
        }
    }
    for (std::uint32_t row = 0; row < rows; ++row) {
        for (std::uint32_t column = 0; column < columns; ++column) {
            const std::uint32_t corner = row * (columns + 1) + column;
            const std::uint32_t below = corner + columns + 1;
            if (row > 0) mesh.triangles.push_back({corner, corner + 1, below + 1});
            if (row + 1 < rows) mesh.triangles.push_back({corner, below + 1, below});
        }
    }
    return mesh;
}

Ray randomRayAt(const MeshData& mesh, const Bounds3& box, Random& random) {
    const Vec3 half = box.diagonal() / 2;
    const Real size = half.maxCoeff();
    const Vec3 center = box.center();
    const Vec3 origin = center + 2 * size * inCube(random);
    const Vec3 vertex = mesh.positions[random.below(mesh.positions.size())];
    switch (random.below(4)) {
        case 0:
            return {origin, inCube(random)};
        case 1:
            return {origin, vertex - origin};
        case 2: {
            const auto [a, b, c] = mesh.corners(static_cast<std::uint32_t>(random.below(mesh.triangles.size())));
            const Real share = random.uniform();
            return {origin, (1 - share) * a + share * b - origin};
        }
        default: {
            const int axis = static_cast<int>(random.below(3));
            Vec3 direction = Vec3::Zero();
            direction[axis] = random.below(2) == 0 ? 1 : -1;
            // In the plane of the vertex, but beside it as often as not.
            Vec3 from = vertex - 3 * size * direction;
            if (random.below(2) == 0) from[(axis + 1) % 3] = origin[(axis + 1) % 3];
            return {from, direction};
        }
    }
}

Ray randomChord(const Bounds3& box, Random& random) {
    const Vec3 half = box.diagonal() / 2;
    const Vec3 from = box.center() + half.cwiseProduct(inCube(random));
    const Vec3 to = box.center() + half.cwiseProduct(inCube(random));
    const Vec3 direction = (to - from).normalized();
    return {from - 2 * box.diagonal().norm() * direction, direction};
}

}  // namespace caustic
