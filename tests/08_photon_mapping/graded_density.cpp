#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "accel/nearest_points.h"
#include "core/random.h"
#include "integrator/photon_map.h"
#include "material/diffuse_material.h"
#include "material/phong_material.h"
#include "material/rough_dielectric_material.h"
#include "math/frame.h"
#include "mesh/triangle_mesh.h"
#include "scene/scene.h"
#include "shape/plane.h"
#include "texture/constant_texture.h"

namespace caustic {
namespace {

constexpr Real pi = std::numbers::pi;

// The k nearest so far, after each offer, whatever their order and however many are alike.
TEST(NearestPoints, KeepsTheNearest) {
    Random random(3, {});
    NearestPoints nearest;
    for (const std::size_t k : {1, 2, 3, 8, 57}) {
        for (const int kinds : {3, 1'000'000}) {
            nearest.start(k, 1e9);
            std::vector<Real> all;
            for (std::uint32_t i = 0; i < 200; ++i) {
                const Real distance = static_cast<Real>(random.below(static_cast<std::uint64_t>(kinds)));
                if (distance <= nearest.mostSquared()) nearest.offer({i, distance});
                all.push_back(distance);
                std::sort(all.begin(), all.end());
                std::vector<Real> kept;
                std::vector<std::uint32_t> places;
                for (const NearPoint& one : nearest.points()) {
                    kept.push_back(one.squaredDistance);
                    places.push_back(one.place);
                }
                std::sort(kept.begin(), kept.end());
                std::sort(places.begin(), places.end());
                const std::size_t count = std::min(k, all.size());
                ASSERT_TRUE(std::equal(kept.begin(), kept.end(), all.begin(), all.begin() + static_cast<long>(count)))
                    << "Whose place does a nearer point take? Is the farthest one still on top?";
                ASSERT_TRUE(std::adjacent_find(places.begin(), places.end()) == places.end())
                    << "Is a point kept twice, or has one lost its place?";
            }
        }
    }
}

// Of points that are as far as the farthest, those that came first stay.
TEST(NearestPoints, KeepsThoseThatCameFirst) {
    NearestPoints nearest;
    nearest.start(4, 50);
    for (std::uint32_t i = 0; i < 9; ++i) nearest.offer({i, 7});
    for (const NearPoint& one : nearest.points()) EXPECT_LT(one.place, 4U) << "Is a point nearer that is as far?";
}

// The search may leave out what is farther than mostSquared: the limit until there are k, then the farthest of them.
TEST(NearestPoints, SaysWhatIsTooFar) {
    NearestPoints nearest;
    nearest.start(3, 50);
    for (const Real distance : {7.0, 40.0}) {
        nearest.offer({0, distance});
        EXPECT_EQ(nearest.mostSquared(), 50) << "Is anything too far before there are k?";
    }
    nearest.offer({1, 9});
    EXPECT_EQ(nearest.mostSquared(), 40) << "The k-th has come: which is the farthest?";
    EXPECT_EQ(nearest.points().front().squaredDistance, 40) << "Is the farthest one on top?";
    nearest.offer({2, 8});
    EXPECT_EQ(nearest.mostSquared(), 9);
    nearest.offer({3, 1});
    nearest.offer({4, 2});
    EXPECT_EQ(nearest.mostSquared(), 7);
    nearest.start(1, 50);
    nearest.offer({0, 0.1});
    EXPECT_EQ(nearest.mostSquared(), 0.1) << "To the last digit?";
}

// A plane that stands askew far from the origin, and where a ray meets it from one of its sides. The frame's n is ng.
struct Place {
    Real size = 1;
    std::shared_ptr<const Material> material = std::make_shared<DiffuseMaterial>(Color(0.3, 0.9, 0.6));
    bool below = false;

    Frame frame() const { return Frame::around(Vec3(0.36, -0.48, 0.8)); }
    Vec3 center() const { return size * Vec3(-2, 5, 1); }
    Vec3 wo() const { return frame().toWorld(Vec3(0.48, 0.36, below ? -0.8 : 0.8)); }

    // The point in the plane at these coordinates around the place.
    Vec3 at(Real s, Real t) const { return center() + size * (s * frame().s + t * frame().t); }

    Scene scene() const {
        SceneObject plane = {std::make_shared<Plane>(center(), frame().n), material, {}, nullptr};
        if (anyOf(material->lobes(), LobeFlags::Transmission)) plane.interior = Interior{1.5, nullptr, 0};
        return Scene({{plane}, {}, Color::Zero(), nullptr});
    }

    Interaction interaction(const Scene& scene) const {
        MediumStack media;
        Color passed;
        RayCounts counts;
        return *scene.follow({center() + size * wo(), -wo()}, media, passed, counts);
    }
};

Photon photonAt(const Vec3& point, const Vec3& wi, const Vec3& ng, const Color& power = Color(1, 2, 3)) {
    return {point, wi, power, ng, 1, PhotonWay::Direct};
}

// Photons at the distances 0.1, 0.2, 0.3 … in all directions, all from above.
std::vector<Photon> spiral(const Place& place, int count) {
    std::vector<Photon> photons;
    for (int i = 1; i <= count; ++i)
        photons.push_back(photonAt(place.at(0.1 * i * std::cos(2.4 * i), 0.1 * i * std::sin(2.4 * i)),
                                   place.frame().toWorld(Vec3(0.6, 0, 0.8)), place.frame().n));
    return photons;
}

std::vector<Real> distances(const PhotonMap::Neighbours& found) {
    std::vector<Real> all;
    for (const NearPoint& one : found.photons) all.push_back(std::sqrt(one.squaredDistance));
    std::sort(all.begin(), all.end());
    return all;
}

void expectDistances(const PhotonMap::Neighbours& found, int count, Real radius, Real size, const char* question) {
    const std::vector<Real> all = distances(found);
    ASSERT_EQ(all.size(), static_cast<std::size_t>(count)) << question;
    for (int i = 0; i < count; ++i)
        EXPECT_NEAR(all[static_cast<std::size_t>(i)] / size, 0.1 * (i + 1), 1e-9) << question;
    EXPECT_NEAR(std::sqrt(found.squaredRadius) / size, radius, 1e-9) << question;
}

// k photons, and a disc that reaches to the next one.
TEST(Neighbours, TheNearestStandForADiscUpToTheNext) {
    for (const Real size : {1e-6, 1.0, 1e6}) {
        const Place place = {size};
        const Scene scene = place.scene();
        const PhotonMap map(spiral(place, 12));
        for (const int k : {1, 3, 11})
            expectDistances(map.neighbours(place.interaction(scene), {.nearest = k, .radius = 5 * size}), k,
                            0.1 * (k + 1), size, "Which photon's distance is the radius, and does it count itself?");
    }
    const Place far = {100};
    const Scene scene = far.scene();
    // One lies just there, and the next one beside it: the disc has an area.
    std::vector<Photon> there = spiral(far, 3);
    there.push_back(photonAt(far.center(), far.frame().n, far.frame().n));
    const auto atCenter = PhotonMap(there).neighbours(far.interaction(scene), {.nearest = 1, .radius = 500});
    EXPECT_EQ(atCenter.photons.size(), 1U) << "The nearest one is just there: which disc is it?";
    EXPECT_NEAR(std::sqrt(atCenter.squaredRadius) / 100, 0.1, 1e-9) << "The nearest one is just there: which disc?";
}

// With k or fewer within the radius, they stand for all of it.
TEST(Neighbours, FewStandForTheWholeRadius) {
    const Place place = {100};
    const Scene scene = place.scene();
    const PhotonMap map(spiral(place, 12));
    expectDistances(map.neighbours(place.interaction(scene), {.nearest = 12, .radius = 500}), 12, 5, 100,
                    "There is no photon behind them: which disc is it?");
    expectDistances(map.neighbours(place.interaction(scene), {.nearest = 40, .radius = 75}), 7, 0.75, 100,
                    "Fewer than k: which disc is it?");
    expectDistances(map.neighbours(place.interaction(scene), {.nearest = 3, .radius = 5}), 0, 0.05, 100,
                    "None is near: which disc is it?");
    // So many in one place that the next one is there, too.
    const Photon one = photonAt(place.center(), place.frame().n, place.frame().n);
    const auto found = PhotonMap(std::vector<Photon>(6, one)).neighbours(place.interaction(scene), {.nearest = 3});
    EXPECT_GE(found.photons.size(), 3U);
    EXPECT_GT(found.squaredRadius, 0) << "A disc without an area?";
}

// A fixed radius: all within it, however many.
TEST(Neighbours, AFixedRadiusTakesAllWithin) {
    const Place place = {0.01};
    const Scene scene = place.scene();
    const PhotonMap map(spiral(place, 30));
    for (const int count : {1, 8, 30})
        expectDistances(
            map.neighbours(place.interaction(scene), {.nearest = {}, .radius = 0.01 * (0.1 * count + 0.05)}), count,
            0.1 * count + 0.05, 0.01, "Which photons are within the radius?");
}

// Photons that come from behind light the other side. They are neither counted nor do they make the disc smaller; but
// what lets light through is lit from both sides.
TEST(Neighbours, CountOnTheSideThatIsSeen) {
    for (const bool below : {false, true}) {
        Place place = {1, std::make_shared<DiffuseMaterial>(Color::Constant(0.5)), below};
        std::vector<Photon> photons = spiral(place, 12);
        // Behind each other there is another one, a bit nearer, from the other side.
        const std::size_t count = photons.size();
        for (std::size_t i = 0; i < count; ++i) {
            Photon other = photons[i];
            other.point = place.center() + 0.99 * (other.point - place.center());
            other.wi = -other.wi;
            if (below) std::swap(other.wi, photons[i].wi);
            photons.push_back(other);
        }
        const PhotonMap map(photons);
        const Scene scene = place.scene();
        const Interaction at = place.interaction(scene);
        for (const DensitySettings& settings :
             {DensitySettings{.nearest = 4, .radius = 3}, {.nearest = {}, .radius = 0.65}}) {
            const auto found = map.neighbours(at, settings);
            EXPECT_GE(found.photons.size(), 4U) << "Do photons from behind take the place of others?";
            for (const NearPoint& one : found.photons) {
                const Vec3 wi = map.photons()[one.place].wi;
                EXPECT_GT(wi.dot(at.hit().ng) * at.wo().dot(at.hit().ng), 0) << "Do photons from behind count?";
            }
        }
        place.material = std::make_shared<RoughDielectricMaterial>(0.4, 0.4);
        const Scene rough = place.scene();
        EXPECT_EQ(map.neighbours(place.interaction(rough), {.nearest = {}, .radius = 0.65}).photons.size(), 12U)
            << "What lets light through is seen by light from behind, too.";
    }
}

// Σ f Φ over the disc's area. A diffuse surface reflects ρ/π of whatever comes.
TEST(Density, IsPowerOverArea) {
    const Color rho(0.3, 0.9, 0.6);
    for (const Real size : {1e-6, 1.0, 1e6}) {
        const Place place = {size};
        const Scene scene = place.scene();
        const PhotonMap map(spiral(place, 12));
        for (const int count : {1, 7, 12}) {
            const Real radius = size * (0.1 * count + 0.03);
            const Color expected = rho / pi * count * Color(1, 2, 3) / (pi * radius * radius);
            const Color found = map.radiance(place.interaction(scene), {.nearest = {}, .radius = radius});
            EXPECT_LE((found / expected - 1).abs().maxCoeff(), 1e-9) << "f, the power, the disc's area?";
        }
    }
    const Place place;
    const Scene scene = place.scene();
    const PhotonMap none({});
    EXPECT_TRUE((none.radiance(place.interaction(scene), {}) == 0).all()) << "No photon, no light.";
}

// The cone filter: a photon counts 1 − d/(κ r), and all by the mean of that over the disc, 1 − 2/(3κ).
TEST(Density, TheConeFilterKeepsTheMean) {
    const Place place = {2};
    const Scene scene = place.scene();
    const PhotonMap map(spiral(place, 5));
    for (const Real kappa : {1.0, 1.6}) {
        Real weights = 0;
        for (int i = 1; i <= 5; ++i) weights += 1 - 0.1 * i / (0.7 * kappa);
        const Real expected = 0.3 / pi * weights / ((1 - 2 / (3 * kappa)) * pi * 1.4 * 1.4);
        const Color found = map.radiance(place.interaction(scene), {.nearest = {}, .radius = 1.4, .cone = kappa});
        const Color colour = Color(1, 3, 2) * Color(1, 2, 3);  // of the surface over its red, and of the power
        EXPECT_LE((found / (expected * colour) - 1).abs().maxCoeff(), 1e-9)
            << "Distance, or its square? And what is the weights' mean?";
    }
}

// Phong's highlight is where light comes from the mirrored side: each photon is asked for its own wi.
TEST(Density, EachPhotonIsScatteredFromWhereItCame) {
    const Place place = {1, std::make_shared<PhongMaterial>(std::make_shared<ConstantTexture>(Color(0.2, 0.1, 0.3)),
                                                            Color(0.5, 0.6, 0.4), 9)};
    const Scene scene = place.scene();
    const Interaction at = place.interaction(scene);
    std::vector<Photon> photons = {
        photonAt(place.at(0.1, 0), place.frame().toWorld(Vec3(-0.48, -0.36, 0.8)), place.frame().n, Color(5, 1, 2)),
        photonAt(place.at(0, 0.2), place.frame().toWorld(Vec3(0.6, 0, 0.8)), place.frame().n, Color(1, 7, 2))};
    Color expected = Color::Zero();
    for (const Photon& photon : photons)
        expected += at.bsdf()->f(at.wo(), photon.wi, TransportMode::Radiance) * photon.power;
    const Color found = PhotonMap(photons).radiance(at, {.nearest = {}, .radius = 0.5});
    EXPECT_LE((found / (expected / (pi * 0.25)) - 1).abs().maxCoeff(), 1e-9) << "Which direction is f asked for?";
}

// Photons lie as dense as their light meets the geometry, by the cosine with ng; light is scattered by the cosine with
// the shading normal.
TEST(Density, SmoothNormalsScatterByTheirOwnCosine) {
    MeshData data;
    data.positions = {Vec3(-9, 0, -9), Vec3(-9, 0, 9), Vec3(9, 0, 9), Vec3(9, 0, -9)};
    const Vec3 ns = Vec3(0.28, 0.96, 0);
    data.normals = {ns};
    data.triangles = {MeshData::Corners{0, 1, 2}, MeshData::Corners{0, 2, 3}};
    data.normalCorners = {MeshData::Corners{0, 0, 0}, MeshData::Corners{0, 0, 0}};
    SceneObject floor = {
        std::make_shared<TriangleMesh>(data), std::make_shared<DiffuseMaterial>(Color::Constant(0.5)), {}, nullptr};
    const Scene scene({{floor}, {}, Color::Zero(), nullptr});
    MediumStack media;
    Color passed;
    RayCounts counts;
    const Interaction at = *scene.follow({Vec3(0.5, 1, 0), -Vec3::UnitY()}, media, passed, counts);
    ASSERT_NEAR(at.hit().ns.dot(ns), 1, 1e-9);
    const Vec3 wi(0.6, 0.8, 0);
    const PhotonMap map(std::vector<Photon>{photonAt(Vec3(0.6, 0, 0), wi, Vec3::UnitY())});
    const Color found = map.radiance(at, {.nearest = {}, .radius = 0.3});
    EXPECT_NEAR(found.x(), 0.5 / pi * wi.dot(ns) / 0.8 / (pi * 0.09), 1e-9)
        << "Which cosine is in it, and which is divided by?";
}

}  // namespace
}  // namespace caustic
