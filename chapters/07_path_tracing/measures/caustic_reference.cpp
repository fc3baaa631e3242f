#include "measures/caustic_reference.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "core/parallel.h"
#include "core/random.h"

namespace caustic {

namespace {

constexpr Real pi = std::numbers::pi;
constexpr Real floorHalf = 4;    // of the square of floor, m
constexpr Real middle = 0.3;     // x of the middle of what is shown
constexpr int mostScatters = 3;  // by the floor; each sends less than a hundredth back to it
constexpr Real least = 1e-7;     // share of a photon that is followed
constexpr int mostInside = 60;   // reflections in a row: a ray along the surface never gets out
constexpr std::int64_t items = 64;

// Share that a boundary reflects. Source: Fresnel's equations; eta is n behind over n before it.
Real reflectance(Real cosine, Real eta) {
    const Real squared = 1 - (1 - cosine * cosine) / (eta * eta);
    if (squared <= 0) return 1;
    const Real beyond = std::sqrt(squared);
    const Real parallel = (eta * cosine - beyond) / (eta * cosine + beyond);
    const Real across = (cosine - eta * beyond) / (cosine + eta * beyond);
    return (parallel * parallel + across * across) / 2;
}

class Counter {
public:
    Counter(const CausticScene& scene, int width)
        : scene_(scene), width_(width), cells_(static_cast<std::size_t>(width * width)) {}

    const std::vector<Real>& cells() const { return cells_; }

    // A photon from the lamp to the ball.
    void fromLamp(Random& random, std::int64_t i, std::int64_t side, Real photons) {
        const Vec3 from = scene_.lamp + scene_.lampSide * Vec3(random.uniform() - 0.5, random.uniform() - 0.5, 0);
        const Vec2 u((static_cast<Real>(i % side) + random.uniform()) / static_cast<Real>(side),
                     (static_cast<Real>(i / side) + random.uniform()) / static_cast<Real>(side));
        Real solidAngle = 0;
        const Vec3 direction = towardsBall(from, u, solidAngle);
        const Real area = scene_.lampSide * scene_.lampSide;
        meetBall(from, direction, scene_.radiance() * area * std::max(Real(0), -direction.z()) * solidAngle / photons,
                 0);
    }

    // Light straight from the lamp that the floor scatters to the ball.
    void fromFloor(Random& random, Real photons) {
        const Vec3 at(floorHalf * random.uniform(-1, 1), floorHalf * random.uniform(-1, 1), 0);
        const Vec3 from = scene_.lamp + scene_.lampSide * Vec3(random.uniform() - 0.5, random.uniform() - 0.5, 0);
        const Real irradiance = irradianceFrom(from, at);
        scatter(at, irradiance * 4 * floorHalf * floorHalf / photons, 1, random);
    }

    // Irradiance, were all the lamp at one point of it.
    Real irradianceFrom(const Vec3& from, const Vec3& at) const {
        const Vec3 way = at - from;
        const Real squared = way.squaredNorm();
        if (ballAlong(from, way / std::sqrt(squared))) return 0;
        const Real cosines = from.z() * from.z() / squared;
        return scene_.radiance() * scene_.lampSide * scene_.lampSide * cosines / squared;
    }

    void useRandom(Random& random) { random_ = &random; }

private:
    // Distance to the ball's near side from outside, when the ray meets it.
    std::optional<Real> ballAlong(const Vec3& from, const Vec3& direction) const {
        const Vec3 way = scene_.ball - from;
        const Real along = way.dot(direction);
        const Real beside = (way - along * direction).squaredNorm();
        const Real inside = scene_.radius * scene_.radius - beside;
        if (along <= 0 || inside <= 0) return std::nullopt;
        return along - std::sqrt(inside);
    }

    Vec3 towardsBall(const Vec3& from, const Vec2& u, Real& solidAngle) const {
        const Vec3 way = scene_.ball - from;
        const Vec3 axis = way.normalized();
        const Real leastCosine = std::sqrt(1 - scene_.radius * scene_.radius / way.squaredNorm());
        solidAngle = 2 * pi * (1 - leastCosine);
        const Real cosine = 1 - u.x() * (1 - leastCosine);
        const Real sine = std::sqrt(std::max(Real(0), 1 - cosine * cosine));
        const Vec3 across = axis.cross(std::abs(axis.x()) < 0.5 ? Vec3::UnitX() : Vec3::UnitY()).normalized();
        const Vec3 upright = axis.cross(across);
        return cosine * axis + sine * (std::cos(2 * pi * u.y()) * across + std::sin(2 * pi * u.y()) * upright);
    }

    // Follows what the ball reflects, and what leaves it after 0, 1, 2 … reflections within.
    void meetBall(const Vec3& from, Vec3 direction, Real flux, int scatters) {
        const auto distance = ballAlong(from, direction);
        if (!distance) return;
        Vec3 at = from + *distance * direction;
        const Vec3 normal = (at - scene_.ball) / scene_.radius;
        const Real cosine = -direction.dot(normal);
        const Real back = reflectance(cosine, scene_.ior);
        meetFloor(at, direction + 2 * cosine * normal, flux * back, flux, scatters);
        const Real beyond = std::sqrt(1 - (1 - cosine * cosine) / (scene_.ior * scene_.ior));
        direction = direction / scene_.ior + (cosine / scene_.ior - beyond) * normal;
        const Real whole = flux;
        flux *= 1 - back;
        for (int inside = 0; inside < mostInside && flux > least * whole; ++inside) {
            at += 2 * (scene_.ball - at).dot(direction) * direction;
            const Vec3 outwards = (at - scene_.ball) / scene_.radius;
            const Real inner = direction.dot(outwards);
            const Real kept = reflectance(inner, 1 / scene_.ior);
            if (kept < 1) {
                const Real outer = std::sqrt(1 - (1 - inner * inner) * scene_.ior * scene_.ior);
                meetFloor(at, scene_.ior * direction + (outer - scene_.ior * inner) * outwards, flux * (1 - kept),
                          whole, scatters);
            }
            direction -= 2 * inner * outwards;
            flux *= kept;
        }
    }

    // Of all that one photon has become at the ball, about one part is scattered on and stands for the others.
    void meetFloor(const Vec3& from, const Vec3& direction, Real flux, Real whole, int scatters) {
        if (direction.z() >= 0) return;
        const Vec3 at = from - from.z() / direction.z() * direction;
        if (std::abs(at.x()) > floorHalf || std::abs(at.y()) > floorHalf) return;
        const Real cell = 2 * CausticScene::shown / width_;
        const Real x = (at.x() - middle + CausticScene::shown) / cell;
        const Real y = (CausticScene::shown - at.y()) / cell;
        if (x >= 0 && x < width_ && y >= 0 && y < width_)
            cells_[static_cast<std::size_t>(static_cast<int>(y) * width_ + static_cast<int>(x))] +=
                flux / (cell * cell);
        if (random_->uniform() * whole < flux) scatter(at, whole, scatters + 1, *random_);
    }

    void scatter(const Vec3& at, Real flux, int scatters, Random& random) {
        if (scatters > mostScatters || flux <= 0) return;
        Real solidAngle = 0;
        const Vec3 direction = towardsBall(at, {random.uniform(), random.uniform()}, solidAngle);
        if (direction.z() <= 0) return;
        meetBall(at, direction, flux * scene_.floor / pi * direction.z() * solidAngle, scatters);
    }

    CausticScene scene_;
    int width_;
    std::vector<Real> cells_;  // irradiance
    Random* random_ = nullptr;
};

// Straight from the lamp: the mean over points of the cell and of the lamp.
Real straight(const CausticScene& scene, const Counter& counter, int width, int x, int y) {
    constexpr int perCell = 8;
    constexpr int perLamp = 8;
    const Real cell = 2 * CausticScene::shown / width;
    Real sum = 0;
    for (int i = 0; i < perCell * perCell; ++i) {
        const Vec3 at(middle - CausticScene::shown + cell * (x + (i % perCell + 0.5) / perCell),
                      CausticScene::shown - cell * (y + (i / perCell + 0.5) / perCell), 0);
        for (int j = 0; j < perLamp * perLamp; ++j) {
            const Vec3 place((j % perLamp + 0.5) / perLamp - 0.5, (j / perLamp + 0.5) / perLamp - 0.5, 0);
            sum += counter.irradianceFrom(scene.lamp + scene.lampSide * place, at);
        }
    }
    return sum / (perCell * perCell * perLamp * perLamp);
}

}  // namespace

Image causticReference(const CausticScene& scene, int width, std::int64_t photons, int threads, std::uint64_t seed) {
    const auto side = static_cast<std::int64_t>(std::ceil(std::sqrt(static_cast<double>(photons) / items)));
    const Real all = static_cast<Real>(side * side * items);
    std::vector<Counter> counters(static_cast<std::size_t>(items), Counter(scene, width));
    parallelFor(items, threads, [&](std::int64_t item) {
        Random random(seed, {static_cast<std::uint64_t>(item)});
        Counter& own = counters[static_cast<std::size_t>(item)];
        own.useRandom(random);
        for (std::int64_t i = 0; i < side * side; ++i) {
            own.fromLamp(random, i, side, all);
            own.fromFloor(random, all);
        }
    });
    Image picture(width, width);
    for (int y = 0; y < width; ++y) {
        for (int x = 0; x < width; ++x) {
            Real irradiance = straight(scene, counters.front(), width, x, y);
            for (const Counter& own : counters) irradiance += own.cells()[static_cast<std::size_t>(y * width + x)];
            picture.set(x, y, Color::Constant(scene.floor / pi * irradiance));
        }
    }
    return picture;
}

}  // namespace caustic
