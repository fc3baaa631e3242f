#include "support/sphere_integral.h"

#include <algorithm>
#include <cmath>

namespace caustic::test {

namespace {

constexpr int deepest = 24;
constexpr std::size_t crowded = 32;

struct Piece {
    SpherePatch patch;
    double sum = 0;    // by Gauss's rule
    bool cut = false;  // whether the integrand is 0 somewhere
};

Piece byGauss(const std::function<double(const Vec3&)>& integrand, const SpherePatch& patch) {
    constexpr double place[3] = {-0.774596669241483377, 0, 0.774596669241483377};
    constexpr double weight[3] = {5.0 / 18, 8.0 / 18, 5.0 / 18};
    const double height = patch.zHigh - patch.zLow;
    const double turn = patch.angleHigh - patch.angleLow;
    Piece piece = {patch};
    for (int i = 0; i < 9; ++i) {
        const double z = patch.zLow + height * (1 + place[i / 3]) / 2;
        const double angle = patch.angleLow + turn * (1 + place[i % 3]) / 2;
        const double value = integrand(directionAt({angle, z}));
        piece.sum += weight[i / 3] * weight[i % 3] * value * height * turn;
        piece.cut = piece.cut || value == 0;
    }
    return piece;
}

// Puts those that are behind the limit behind the others, and tells how many are before it.
std::size_t before(std::span<Vec2> crowd, int axis, double limit) {
    const auto middle = std::partition(crowd.begin(), crowd.end(), [&](const Vec2& at) { return at[axis] < limit; });
    return static_cast<std::size_t>(middle - crowd.begin());
}

double refined(const std::function<double(const Vec3&)>& integrand, const Piece& whole, double tolerance,
               std::span<Vec2> crowd, int depth) {
    const SpherePatch& patch = whole.patch;
    const double z = (patch.zLow + patch.zHigh) / 2;
    const double angle = (patch.angleLow + patch.angleHigh) / 2;
    const Piece parts[4] = {byGauss(integrand, {patch.zLow, z, patch.angleLow, angle}),
                            byGauss(integrand, {patch.zLow, z, angle, patch.angleHigh}),
                            byGauss(integrand, {z, patch.zHigh, patch.angleLow, angle}),
                            byGauss(integrand, {z, patch.zHigh, angle, patch.angleHigh})};
    double sum = 0;
    bool cut = whole.cut;
    for (const Piece& part : parts) {
        sum += part.sum;
        cut = cut || part.cut;
    }
    // An edge goes through a piece: points of the rule on one side say nothing of the other.
    const bool edge = cut && !crowd.empty() && depth < 8;
    if ((std::abs(sum - whole.sum) <= tolerance && crowd.size() <= crowded && !edge) || depth >= deepest) return sum;

    const std::size_t low = before(crowd, 1, z);
    const std::span<Vec2> halves[2] = {crowd.first(low), crowd.subspan(low)};
    sum = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        const std::span<Vec2> half = halves[i / 2];
        const std::size_t left = before(half, 0, angle);
        sum += refined(integrand, parts[i], tolerance, i % 2 == 0 ? half.first(left) : half.subspan(left), depth + 1);
    }
    return sum;
}

}  // namespace

Vec2 placeOnSphere(const Vec3& direction) { return {std::atan2(direction.y(), direction.x()), direction.z()}; }

Vec3 directionAt(const Vec2& place) {
    const double r = std::sqrt(std::max(0.0, 1 - place.y() * place.y()));
    return {r * std::cos(place.x()), r * std::sin(place.x()), place.y()};
}

double sphereIntegral(const std::function<double(const Vec3&)>& integrand, const SpherePatch& patch, double tolerance,
                      std::span<Vec2> crowd) {
    return refined(integrand, byGauss(integrand, patch), tolerance, crowd, 1);
}

double hemisphereIntegral(const std::function<double(const Vec3&)>& integrand, double zLow) {
    constexpr int bands = 16;
    constexpr int sectors = 64;
    constexpr double turn = 2 * std::numbers::pi / sectors;
    double sum = 0;
    for (int i = 0; i < bands * sectors; ++i) {
        const double z = zLow + static_cast<double>(i / sectors) / bands;
        const double angle = turn * (i % sectors) - std::numbers::pi;
        sum += sphereIntegral(integrand, {z, z + 1.0 / bands, angle, angle + turn}, 1e-8, {});
    }
    return sum;
}

}  // namespace caustic::test
