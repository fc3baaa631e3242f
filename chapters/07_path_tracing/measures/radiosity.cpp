#include "measures/radiosity.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "camera/camera.h"
#include "core/parallel.h"

namespace caustic {

namespace {

constexpr int iterations = 60;  // light loses a third at each step: 1e-10 of it is left
constexpr Real inset = 1e-4;    // from the edges, where another wall is infinitely near

Vec3 normalOf(const Vec3& edgeU, const Vec3& edgeV) { return edgeU.cross(edgeV).normalized(); }

// Behind the mirror x = −1.
Vec3 image(const Vec3& point) { return {-2 - point.x(), point.y(), point.z()}; }

// Share of the cosine-weighted hemisphere over a point that a polygon takes, which is all in front of it.
// Source: Lambert 1760; Baum, Rushmeier, Winget 1989, eq. 10.
Real polygonFactor(const Vec3& point, const Vec3& normal, const std::array<Vec3, 4>& corners) {
    Real sum = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec3 from = corners[i] - point;
        const Vec3 to = corners[(i + 1) % corners.size()] - point;
        const Vec3 across = from.cross(to);
        const Real sine = across.norm();
        if (sine > 0) sum += std::atan2(sine, from.dot(to)) * across.dot(normal) / sine;
    }
    return std::abs(sum) / (2 * std::numbers::pi);
}

}  // namespace

BoxRadiosity::BoxRadiosity(const DiffuseBox& box, int patches, int threads)
    : box_(box), walls_(box.diffuseWalls()), perEdge_(patches) {
    const BoxWall shining = box.lamp();
    // At the very ceiling, so that it is in nobody's way.
    lamp_ = {{shining.corner.x(), shining.corner.y(), 1},
             shining.edgeU,
             shining.edgeV,
             Color::Zero(),
             Color::Constant(box.radiance)};
    for (const BoxWall& wall : walls_) addWall(wall);
    solve(threads);
    tabulate(threads);
}

void BoxRadiosity::addWall(const BoxWall& wall) {
    const Vec3 u = wall.edgeU / perEdge_;
    const Vec3 v = wall.edgeV / perEdge_;
    const Real half = box_.lampSide / 2;
    for (int j = 0; j < perEdge_; ++j) {
        for (int i = 0; i < perEdge_; ++i) {
            Patch patch = {wall.corner + i * u + j * v, u, v, wall.reflectance, Color::Zero()};
            const Vec3 end = patch.corner + u + v;
            const auto overlap = [half](Real a, Real b) {
                return std::max(Real(0), std::min(std::max(a, b), half) - std::max(std::min(a, b), -half));
            };
            if (patch.corner.z() == 1 && end.z() == 1)
                patch.open -=
                    overlap(patch.corner.x(), end.x()) * overlap(patch.corner.y(), end.y()) / u.cross(v).norm();
            patches_.push_back(patch);
        }
    }
}

Real BoxRadiosity::factor(const Vec3& point, const Vec3& normal, const Patch& patch) const {
    const std::array<Vec3, 4> corners = {patch.corner, patch.corner + patch.edgeU,
                                         patch.corner + patch.edgeU + patch.edgeV, patch.corner + patch.edgeV};
    const auto coplanar = [&](const Vec3& corner) { return std::abs((corner - point).dot(normal)) < 1e-12; };
    Real sum = coplanar(corners[0]) && coplanar(corners[2]) ? 0 : polygonFactor(point, normal, corners);
    if (!box_.mirror) return sum;
    const std::array<Vec3, 4> images = {image(corners[0]), image(corners[1]), image(corners[2]), image(corners[3])};
    if (!(coplanar(images[0]) && coplanar(images[2]))) sum += box_.mirrored * polygonFactor(point, normal, images);
    return sum;
}

void BoxRadiosity::solve(int threads) {
    const std::size_t count = patches_.size();
    std::vector<std::vector<Real>> factors(count, std::vector<Real>(count));
    std::vector<Color> direct(count);
    parallelFor(static_cast<std::int64_t>(count), threads, [&](std::int64_t item) {
        const std::size_t i = static_cast<std::size_t>(item);
        const Patch& at = patches_[i];
        const Vec3 point = at.corner + (at.edgeU + at.edgeV) / 2;
        const Vec3 normal = normalOf(at.edgeU, at.edgeV);
        for (std::size_t j = 0; j < count; ++j) factors[i][j] = patches_[j].open * factor(point, normal, patches_[j]);
        direct[i] = factor(point, normal, lamp_) * lamp_.radiance;
    });
    std::vector<Color> next(count);
    for (int iteration = 0; iteration < iterations; ++iteration) {
        for (std::size_t i = 0; i < count; ++i) {
            Color sum = direct[i];
            for (std::size_t j = 0; j < count; ++j) sum += factors[i][j] * patches_[j].radiance;
            next[i] = patches_[i].reflectance * sum;
        }
        for (std::size_t i = 0; i < count; ++i) patches_[i].radiance = next[i];
    }
}

Color BoxRadiosity::gathered(const Vec3& point, const Vec3& normal) const {
    Color sum = factor(point, normal, lamp_) * lamp_.radiance;
    for (const Patch& patch : patches_) sum += patch.open * factor(point, normal, patch) * patch.radiance;
    return sum;
}

void BoxRadiosity::tabulate(int threads) {
    const int side = 2 * perEdge_ + 1;
    for (const BoxWall& wall : walls_) {
        std::vector<Color> nodes(static_cast<std::size_t>(side * side));
        const Vec3 normal = normalOf(wall.edgeU, wall.edgeV);
        parallelFor(side * side, threads, [&](std::int64_t node) {
            const auto along = [&](std::int64_t k) {
                return std::clamp(static_cast<Real>(k) / (side - 1), inset, 1 - inset);
            };
            const Vec3 point = wall.corner + along(node % side) * wall.edgeU + along(node / side) * wall.edgeV;
            nodes[static_cast<std::size_t>(node)] = wall.reflectance * gathered(point, normal);
        });
        nodes_.push_back(std::move(nodes));
    }
}

Color BoxRadiosity::tabulated(std::size_t wall, const Vec2& uv) const {
    const int cells = 2 * perEdge_;
    const Vec2 place = uv * cells;
    const int i = std::clamp(static_cast<int>(place.x()), 0, cells - 1);
    const int j = std::clamp(static_cast<int>(place.y()), 0, cells - 1);
    const Vec2 part = place - Vec2(i, j);
    const auto node = [&](int di, int dj) {
        return nodes_[wall][static_cast<std::size_t>((j + dj) * (cells + 1) + i + di)];
    };
    const Color below = (1 - part.x()) * node(0, 0) + part.x() * node(1, 0);
    const Color above = (1 - part.x()) * node(0, 1) + part.x() * node(1, 1);
    return (1 - part.y()) * below + part.y() * above;
}

// Which wall is seen: the first plane that a ray meets within the box; a mirror is passed into the box behind it.
Color BoxRadiosity::seen(Vec3 origin, Vec3 direction) const {
    Color passed = Color::Ones();
    for (int reflections = 0; reflections < 2; ++reflections) {
        Real nearest = std::numeric_limits<Real>::infinity();
        Color found = Color::Zero();
        for (std::size_t i = 0; i < walls_.size(); ++i) {
            const BoxWall& wall = walls_[i];
            const Vec3 normal = normalOf(wall.edgeU, wall.edgeV);
            const Real t = (wall.corner - origin).dot(normal) / direction.dot(normal);
            const Vec3 at = origin + t * direction - wall.corner;
            const Vec2 uv(at.dot(wall.edgeU) / wall.edgeU.squaredNorm(), at.dot(wall.edgeV) / wall.edgeV.squaredNorm());
            const bool inside = (uv.array() >= 0).all() && (uv.array() <= 1).all();
            if (!(t > 1e-9) || t >= nearest || !inside) continue;
            nearest = t;
            found = tabulated(i, uv);
        }
        const Real toMirror = (-1 - origin.x()) / direction.x();
        const Vec3 at = origin + toMirror * direction;
        const bool mirrors =
            box_.mirror && toMirror > 1e-9 && toMirror < nearest && at.tail<2>().cwiseAbs().maxCoeff() <= 1;
        if (!mirrors) return passed * found;
        passed *= box_.mirrored;
        origin = at;
        direction.x() = -direction.x();
    }
    return Color::Zero();
}

Image BoxRadiosity::picture(const Camera& camera, int perAxis, int threads) const {
    Image picture(camera.width(), camera.height());
    parallelFor(camera.height(), threads, [&](std::int64_t row) {
        const int y = static_cast<int>(row);
        for (int x = 0; x < camera.width(); ++x) {
            Color sum = Color::Zero();
            for (int k = 0; k < perAxis * perAxis; ++k) {
                const Vec2 film(x + (k % perAxis + 0.5) / perAxis, y + (k / perAxis + 0.5) / perAxis);
                const Ray ray = camera.sampleRay(film, {0.5, 0.5});
                sum += seen(ray.origin, ray.direction);
            }
            picture.set(x, y, sum / (perAxis * perAxis));
        }
    });
    return picture;
}

}  // namespace caustic
