#include "failures/failure_kinds.h"

#include <cmath>

#include "accel/point_kd_tree.h"
#include "integrator/photon_grid.h"
#include "measures/spot_under_mirror.h"
#include "modeler/objects.h"
#include "sampling/independent_sampler.h"

namespace caustic {

namespace {

Vec3 inBox(Random& random, const Vec3& low, const Vec3& high) {
    return {random.uniform(low.x(), high.x()), random.uniform(low.y(), high.y()), random.uniform(low.z(), high.z())};
}

std::int64_t byBruteForce(const std::vector<Vec3>& points, const Vec3& query, Real radius) {
    std::int64_t count = 0;
    for (const Vec3& point : points) count += (point - query).squaredNorm() <= radius * radius;
    return count;
}

template <typename Structure>
std::int64_t countedBy(const Structure& structure, const Vec3& query, Real radius) {
    std::int64_t count = 0;
    structure.within(query, radius, [&count](const NearPoint&) { ++count; });
    return count;
}

// The same lists, but whoever is in one counts: no look at the cube that a photon is in.
std::int64_t byWholeLists(const std::vector<Vec3>& points, const Vec3& query, Real radius, Real cell) {
    const auto slotOf = [&](const Eigen::Vector3i& cube) {
        const auto hash = static_cast<std::uint32_t>(cube.x()) * 73856093U ^
                          static_cast<std::uint32_t>(cube.y()) * 19349663U ^
                          static_cast<std::uint32_t>(cube.z()) * 83492791U;
        return hash % points.size();
    };
    const auto cubeOf = [&](const Vec3& point) -> Eigen::Vector3i {
        return (point / cell).array().floor().cast<int>();
    };
    const Eigen::Vector3i low = cubeOf(query - Vec3::Constant(radius));
    const Eigen::Vector3i high = cubeOf(query + Vec3::Constant(radius));
    std::int64_t count = 0;
    for (int z = low.z(); z <= high.z(); ++z) {
        for (int y = low.y(); y <= high.y(); ++y) {
            for (int x = low.x(); x <= high.x(); ++x) {
                for (const Vec3& point : points)
                    count +=
                        slotOf(cubeOf(point)) == slotOf({x, y, z}) && (point - query).squaredNorm() <= radius * radius;
            }
        }
    }
    return count;
}

// A point just outside the box of a lit wall's photons. Fragile: nothing is there, says the box.
std::vector<bool> border(Random& random) {
    std::vector<Vec3> wall;
    for (int i = 0; i < 200; ++i) wall.push_back(inBox(random, {0, 0, 0}, {1, 1, 0}));
    const Real radius = random.uniform(0.1, 0.2);
    Vec3 query(random.uniform(-0.5 * radius, 0), random.uniform(), 0);
    while (byBruteForce(wall, query, radius) == 0) query.x() += 0.1 * radius;
    Bounds3 box;
    for (const Vec3& point : wall) box.extend(point);
    const std::int64_t truth = byBruteForce(wall, query, radius);
    const HashGrid grid(wall, 2 * radius);
    return {(box.contains(query) ? truth : 0) == truth, countedBy(grid, query, radius) == truth,
            countedBy(PointKdTree(wall), query, radius) == truth};
}

// A few photons in a small table.
std::vector<bool> collisions(Random& random) {
    std::vector<Vec3> points;
    const auto count = 20 + random.below(80);
    for (std::uint64_t i = 0; i < count; ++i) points.push_back(inBox(random, -Vec3::Ones(), Vec3::Ones()));
    const Real radius = random.uniform(0.2, 0.5);
    const Vec3 query = inBox(random, -Vec3::Ones(), Vec3::Ones());
    const std::int64_t truth = byBruteForce(points, query, radius);
    const HashGrid grid(points, radius);
    return {byWholeLists(points, query, radius, radius) == truth, countedBy(grid, query, radius) == truth};
}

// A point on a thin wall that is lit from behind as well. Its radius must shrink for the photons of this side only.
// Fragile: all that lie within the radius count (as in a renderer in use).
std::vector<bool> behindAWall(Random& random) {
    const Scene scene(
        {{diffuseRectangle({-1, 0, -1}, {0, 0, 2}, {2, 0, 0}, Color(0.8, 0.5, 0.3))}, {}, Color::Zero(), {}});
    const IndependentSampler sampler(1);
    RayCounts counts;
    const Ray ray = {{0, 1, 0}, Vec3(random.uniform(-0.5, 0.5), -1, random.uniform(-0.5, 0.5)).normalized()};
    const EyePath path = findVisiblePoint(scene, ray, {}, {}, sampler.start(0, {0, 0}, 0), counts);
    const Real radius = random.uniform(0.01, 0.1);
    std::vector<Photon> photons;
    std::int64_t front = 0;
    std::int64_t within = 0;
    for (int i = 0; i < 60; ++i) {
        Photon photon;
        photon.point = path.point->at.point() + inBox(random, {-radius, 0, -radius}, {radius, 0, radius});
        photon.wi = inBox(random, -Vec3::Ones(), Vec3::Ones()).normalized();
        photon.power = Color::Ones();
        photon.length = 2;
        photons.push_back(photon);
        if ((photon.point - path.point->at.point()).norm() > radius) continue;
        ++within;
        front += photon.wi.y() > 0;
    }
    const Real alpha = random.uniform(0.3, 0.9);
    const Real before = random.uniform(0, 50);
    const auto shrunk = [&](std::int64_t found) {
        PointStatistics pixel = {radius, before, Color::Zero()};
        update(pixel, {found, Color::Ones()}, alpha);
        return pixel.radius;
    };
    const auto m = static_cast<Real>(front);
    const Real truth = radius * std::sqrt((before + alpha * m) / (before + m));
    const std::int64_t gathered = PhotonGrid(photons, radius).gather(*path.point, radius, 10).photons;
    return caustic::within(1e-12 * truth, truth, {shrunk(within), shrunk(gathered)});
}

// A pixel that no photon has ever found, pass after pass. Fragile: the formula as it stands.
std::vector<bool> neverHit(Random& random) {
    const Real radius = random.uniform(1e-3, 1);
    const Real alpha = random.uniform(0.01, 0.99);
    PointStatistics pixel = {radius, 0, Color::Zero()};
    Real plain = radius;
    for (std::uint64_t pass = 0; pass < 1 + random.below(5); ++pass) {
        update(pixel, {0, Color::Zero()}, alpha);
        const Real n = 0;
        const Real m = 0;
        plain *= std::sqrt((n + alpha * m) / (n + m));
    }
    return within(0, radius, {plain, pixel.radius});
}

constexpr std::int64_t passes = 100;
constexpr Real tolerance = 0.1;  // of the radiance

struct Spot {
    SpotUnderMirror scene;
    SppmSettings settings;
};

// At random, with a start radius so large that the first pass is too dark by this share; about 100 photons within it.
Spot spotWith(Random& random, Real bias) {
    Spot one;
    one.scene.mirrorHeight = random.uniform(0.2, 0.4);
    one.scene.lampHeight = one.scene.mirrorHeight * random.uniform(0.4, 0.9);
    one.scene.floorReflectance = random.uniform(0.2, 0.9);
    one.scene.intensity = random.uniform(0.5, 20);
    Real low = 0;
    Real high = 10;
    for (int i = 0; i < 50; ++i) {
        const Real middle = (low + high) / 2;
        (one.scene.biasWithin(middle) < bias ? low : high) = middle;
    }
    one.settings.radius = low;
    one.scene.halfAngle = std::atan(1.4 * low / one.scene.apparent());
    one.settings.photons = 60;
    return one;
}

std::vector<bool> startRadius(Random& random) {
    const Spot spot = spotWith(random, 0.03);
    const std::uint64_t seed = random.below(1U << 30);
    std::vector<bool> right;
    for (const Real factor : {0.01, 0.1, 1.0, 10.0, 100.0}) {
        SppmSettings settings = spot.settings;
        settings.radius *= factor;
        const Real truth = spot.scene.truth();
        right.push_back(within(tolerance * truth, truth, {spot.scene.found(settings, passes, seed)})[0]);
    }
    return right;
}

std::vector<bool> alphas(Random& random) {
    const Spot spot = spotWith(random, 0.15);
    const std::uint64_t seed = random.below(1U << 30);
    std::vector<bool> right;
    for (const Real alpha : {0.001, 2.0 / 3, 0.999}) {
        SppmSettings settings = spot.settings;
        settings.alpha = alpha;
        settings.photons = 8;
        const Real truth = spot.scene.truth();
        right.push_back(within(tolerance * truth, truth, {spot.scene.found(settings, passes, seed)})[0]);
    }
    return right;
}

}  // namespace

std::vector<FailureKind> structureKinds() {
    return {
        {"grid's border: a point just outside the box of a wall's photons",
         {{"grid with a box around it", false}, {"hash grid", true}, {"KD-tree", true}},
         border},
        {"hash collisions: cubes that share a list", {{"whole lists", false}, {"hash grid", true}}, collisions},
        {"wrong side: a thin wall lit from behind; the radius afterwards",
         {{"all photons within the radius count", false}, {"those that scatter to the eye count", true}},
         behindAWall},
        {"never hit: passes without a photon", {{"rule ② as its formula stands", false}, {"rule ②", true}}, neverHit}};
}

std::vector<FailureKind> settingKinds() {
    return {{"start radius: a spot of light, off by more than 10 % after 100 passes",
             {{"too small: × 0.01", false},
              {"× 0.1", false},
              {"start radius by a bias of 3 %", true},
              {"× 10", false},
              {"too large: × 100", false}},
             startRadius},
            {"α: a spot of light from far too large a radius, off by more than 10 % after 100 passes",
             {{"α = 0.001: all noise", false}, {"α = 2/3", true}, {"α = 0.999: all blur", false}},
             alphas}};
}

}  // namespace caustic
