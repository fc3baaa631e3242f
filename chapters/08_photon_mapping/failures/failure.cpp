#include <cmath>
#include <numbers>

#include "camera/box_filter.h"
#include "figures.h"
#include "integrator/bidirectional_path_tracer.h"
#include "integrator/path_tracer.h"
#include "integrator/photon_mapper.h"
#include "light/cone_light.h"
#include "light/point_light.h"
#include "material/diffuse_material.h"
#include "material/mirror_material.h"
#include "modeler/objects.h"
#include "sampling/independent_sampler.h"
#include "shape/rectangle.h"
#include "textbook_density.h"

namespace caustic {

namespace {

constexpr Real pi = std::numbers::pi;
constexpr Real infinity = std::numeric_limits<Real>::infinity();
const BoxFilter filter;

Color grey(Real value) { return Color::Constant(value); }

SceneObject floorOf(Real reflectance) {
    return diffuseRectangle({-20, -20, 0}, {40, 0, 0}, {0, 40, 0}, grey(reflectance));
}

Ray towards(const Vec3& from, const Vec3& to) { return {from, (to - from).normalized()}; }

// What comes along a ray, the mean of some paths.
Real seenBy(const Integrator& integrator, const Ray& ray, int paths, const Sampler& sampler) {
    Real sum = 0;
    RayCounts counts;
    for (int i = 0; i < paths; ++i)
        sum += integrator.Li(ray, integrator.scene().mediaAt(ray.origin), sampler.start(0, {0, 0}, i), counts).x();
    return sum / paths;
}

// One way to use photons, in a scene of a few metres.
struct PhotonWish {
    MapUse use;
    std::int64_t photons = 1000;
    DensitySettings density = {.nearest = 40, .radius = 0.5};
    int paths = 1;
    int gatherRays = 64;
};

Real byPhotons(const Scene& scene, const Ray& ray, const PhotonWish& wish, std::uint64_t seed) {
    const IndependentSampler sampler(seed);
    PhotonMapperSettings settings = {.photons = wish.photons, .use = wish.use};
    settings.density = wish.density;
    settings.caustics = wish.density;
    settings.gatherRays = wish.gatherRays;
    return seenBy(PhotonMapper(scene, sampler, filter, settings, 1), ray, wish.paths, sampler);
}

// Of each use of photons, whether it gives what is known.
std::vector<bool> rightByPhotons(const SceneDescription& description, const Ray& ray, Real truth, Real tolerance,
                                 const std::vector<PhotonWish>& wishes, std::uint64_t seed) {
    const Scene scene(description);
    std::vector<bool> right;
    for (const PhotonWish& wish : wishes)
        right.push_back(std::abs(byPhotons(scene, ray, wish, seed) - truth) <= tolerance);
    return right;
}

// A cone of light from above onto a table, near whose edge it is looked at. Half of the disc hangs in the air.
std::vector<bool> tableEdge(Random& random) {
    const Real rho = random.uniform(0.3, 0.9);
    const Real intensity = random.uniform(1, 10);
    const Vec3 target(-random.uniform(1e-3, 1e-2), 0, 0);
    const Vec3 lamp(random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1), random.uniform(1, 2));
    SceneDescription scene;
    scene.objects = {diffuseRectangle({-3, -3, 0}, {3, 0, 0}, {0, 6, 0}, grey(rho))};
    scene.lights = {std::make_shared<ConeLight>(lamp, -Vec3::UnitZ(), 0.4, grey(intensity))};
    const Real truth = rho / pi * intensity * lamp.z() / std::pow((lamp - target).norm(), 3);
    return rightByPhotons(scene, towards({-1, 0.3, 1}, target), truth, 0.25 * truth,
                          {{MapUse::Everything}, {MapUse::Indirect}}, random.below(1U << 30));
}

// Light falls on the floor on one side of a thin wall that doesn't end; on the other side it is dark.
std::vector<bool> thinWall(Random& random) {
    const Real rho = random.uniform(0.3, 0.9);
    const Vec3 lamp(-random.uniform(0.3, 0.8), random.uniform(-0.2, 0.2), random.uniform(0.8, 1.5));
    const Vec3 target(random.uniform(0.002, 0.02), random.uniform(-0.1, 0.1), 0);
    SceneDescription scene;
    scene.objects = {floorOf(rho), diffuseRectangle({0, -20, 0}, {0, 40, 0}, {0, 0, 20}, grey(rho))};
    scene.lights = {std::make_shared<ConeLight>(lamp, Vec3(-lamp.x(), 0, -lamp.z()), 0.3, grey(5))};
    return rightByPhotons(scene, towards({1, 0.2, 1}, target), 0, 0,
                          {{MapUse::Everything}, {MapUse::Indirect}, {MapUse::Gather}}, random.below(1U << 30));
}

// A floor by a wall, both lit: a ball around a place near the corner holds photons of both.
std::vector<bool> corner(Random& random) {
    const Real rho = random.uniform(0.3, 0.9);
    const Vec3 lamp(random.uniform(0.8, 1.2), random.uniform(-0.2, 0.2), random.uniform(0.2, 0.4));
    const Vec3 target(random.uniform(1e-3, 1e-2), random.uniform(-0.1, 0.1), 0);
    SceneDescription scene;
    // Black, so that direct light is all that there is.
    scene.objects = {floorOf(rho), diffuseRectangle({0, -20, 0}, {0, 40, 0}, {0, 0, 20}, grey(0))};
    scene.lights = {std::make_shared<ConeLight>(lamp, Vec3(-lamp.x(), 0, 0.1 - lamp.z()), 0.3, grey(5))};
    const Real truth = rho / pi * 5 * lamp.z() / std::pow((lamp - target).norm(), 3);
    const bool lit = (target - lamp).normalized().dot(Vec3(-lamp.x(), 0, 0.1 - lamp.z()).normalized()) > std::cos(0.3);
    return rightByPhotons(scene, towards({1, 0.2, 1}, target), lit ? truth : 0, 0.25 * truth,
                          {{MapUse::Everything}, {MapUse::Indirect}}, random.below(1U << 30));
}

// A cone of light is thrown onto the floor by a mirror, and the floor is looked at in the mirror.
struct MirroredSpot {
    explicit MirroredSpot(Random& random)
        : rho(random.uniform(0.3, 0.9)),
          mirror(random.uniform(0.3, 1)),
          lamp(random.uniform(-0.3, 0.3), random.uniform(-0.3, 0.3), random.uniform(0.8, 1.5)),
          target(random.uniform(0.6, 1.2), random.uniform(-0.3, 0.3), 0) {}

    Real rho;
    Real mirror;
    Vec3 lamp;
    Vec3 target;
    Real halfAngle = 0.15;

    Vec3 image() const { return {-2 - lamp.x(), lamp.y(), lamp.z()}; }
    Vec3 mirroredTarget() const { return {-2 - target.x(), target.y(), 0}; }

    // At the target, of the floor itself.
    Real radiance() const { return mirror * rho / pi * 5 * lamp.z() / std::pow((target - image()).norm(), 3); }

    SceneDescription scene() const {
        SceneDescription scene;
        scene.objects = {floorOf(rho),
                         {std::make_shared<Rectangle>(Vec3(-1, -10, 0), Vec3(0, 20, 0), Vec3(0, 0, 20)),
                          std::make_shared<MirrorMaterial>(grey(mirror)),
                          {},
                          nullptr}};
        scene.lights = {std::make_shared<ConeLight>(lamp, mirroredTarget() - lamp, halfAngle, grey(5))};
        return scene;
    }
};

std::vector<bool> causticInMirror(Random& random) {
    const MirroredSpot spot(random);
    const Scene scene(spot.scene());
    const Ray ray = towards({0.4, random.uniform(-0.3, 0.3), random.uniform(1.6, 2.5)}, spot.mirroredTarget());
    const Real truth = spot.mirror * spot.radiance();
    const std::uint64_t seed = random.below(1U << 30);
    const IndependentSampler sampler(seed);
    const PathTracer paths(scene, sampler, filter, {{8, 1}, Direct::Mis});
    const BidirectionalPathTracer both(scene, sampler, filter, {8, 1});
    const PhotonWish wish = {MapUse::Indirect, 2000, {.nearest = 150, .radius = 0.3}};
    return within(0.6 * truth, truth,
                  {seenBy(paths, ray, 32, sampler), seenBy(both, ray, 32, sampler), byPhotons(scene, ray, wish, seed)});
}

// Just outside of the spot: what is blurred gets light that isn't there.
std::vector<bool> besideCaustic(Random& random) {
    MirroredSpot spot(random);
    const Vec3 axis = (spot.target - spot.image()).normalized();
    const Vec3 across = Vec3(0, 1, 0) - axis.y() * axis;
    const Vec3 edge =
        spot.image() + 10 * (std::cos(spot.halfAngle) * axis + std::sin(spot.halfAngle) * across.normalized());
    const Vec3 way = edge - spot.image();
    const Vec3 border = spot.image() - spot.image().z() / way.z() * way;
    const Vec3 place = border + Vec3(0, random.uniform(0.02, 0.04), 0);
    const DensitySettings fine = {.nearest = {}, .radius = 0.015};
    return rightByPhotons(spot.scene(), towards({1.5, 0.2, 1}, place), 0, 0,
                          {{MapUse::Indirect, 1000}, {MapUse::Indirect, 1000, fine}}, random.below(1U << 30));
}

// A lamp at a point within a ball of glass, over a floor. All its light leaves the ball straight on, and none that is
// asked for does: the glass is in the way.
std::vector<bool> lampInGlass(Random& random) {
    const Real rho = random.uniform(0.3, 0.9);
    const Vec3 lamp(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(0.8, 1.2));
    const Vec3 target = lamp + Vec3(random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1), -lamp.z());
    SceneDescription description;
    description.objects = {floorOf(rho), glassBall(lamp, random.uniform(0.2, 0.5), random.uniform(1.2, 1.8))};
    description.lights = {std::make_shared<ConeLight>(lamp, -Vec3::UnitZ(), 0.35, grey(5))};
    const Scene scene(description);
    const Ray ray = towards({3, 0, 1}, target);
    const std::uint64_t seed = random.below(1U << 30);
    const IndependentSampler sampler(seed);
    const PathTracer paths(scene, sampler, filter, {{16, 1}, Direct::Mis});
    const Real truth = rho / pi * 5 * lamp.z() / std::pow((lamp - target).norm(), 3);
    const PhotonWish wish = {MapUse::Indirect, 1500, {.nearest = 150, .radius = 0.3}};
    return within(0.6 * truth, truth, {seenBy(paths, ray, 32, sampler), byPhotons(scene, ray, wish, seed)});
}

// A plate in the dark on which photons lie as I like, and where a ray meets its middle.
struct Plate {
    Scene scene;
    Interaction at;

    Plate(Real rho, const Vec3& from)
        : scene({{diffuseRectangle({-9, -9, 0}, {18, 0, 0}, {0, 18, 0}, grey(rho))}, {}, grey(0), nullptr}),
          at(meet(scene, from)) {}

    static Interaction meet(const Scene& scene, const Vec3& from) {
        MediumStack media;
        Color passed;
        RayCounts counts;
        return *scene.follow(towards(from, Vec3::Zero()), media, passed, counts);
    }
};

std::vector<Photon> onDisc(Random& random, std::size_t count, Real radius, const Vec3& wi) {
    std::vector<Photon> photons;
    while (photons.size() < count) {
        const Vec3 point(random.uniform(-radius, radius), random.uniform(-radius, radius), 0);
        if (point.norm() < radius) photons.push_back({point, wi, grey(1), Vec3::UnitZ(), 1, PhotonWay::Direct});
    }
    return photons;
}

// Fewer photons than are asked for: they are all that there is within the radius.
std::vector<bool> fewerThanK(Random& random) {
    const Plate plate(0.5, {0.3, 0.2, 1});
    const std::size_t count = 1 + random.below(30);
    const Real radius = random.uniform(0.1, 1);
    const PhotonMap map(onDisc(random, count, radius, Vec3::UnitZ()));
    const Real truth = 0.5 / pi * static_cast<Real>(count) / (pi * radius * radius);
    return within(1e-9 * truth, truth,
                  {textbookRadiance(map, plate.at, 50, infinity).x(),
                   map.radiance(plate.at, {.nearest = 50, .radius = radius}).x()});
}

// One photon alone, at the very place.
std::vector<bool> onePhoton(Random& random) {
    const Plate plate(0.5, {0.3, 0.2, 1});
    const Real radius = random.uniform(0.1, 1);
    const std::vector<Photon> one = {{plate.at.point(), Vec3::UnitZ(), grey(1), Vec3::UnitZ(), 1, PhotonWay::Direct}};
    const PhotonMap map(one);
    const int k = 1 + static_cast<int>(random.below(20));
    const Real truth = 0.5 / pi / (pi * radius * radius);
    return within(1e-9 * truth, truth,
                  {textbookRadiance(map, plate.at, k, infinity).x(),
                   map.radiance(plate.at, {.nearest = k, .radius = radius}).x()});
}

// No photon within reach.
std::vector<bool> noPhoton(Random& random) {
    const Plate plate(0.5, {0.3, 0.2, 1});
    std::vector<Photon> photons = onDisc(random, 100, 0.5, Vec3::UnitZ());
    for (Photon& photon : photons) photon.point.x() += 3;
    const PhotonMap map(photons);
    return within(0, 0,
                  {textbookRadiance(map, plate.at, 50, infinity).x(),
                   map.radiance(plate.at, {.nearest = 50, .radius = 0.5}).x()});
}

// The plate is lit from below and looked at from above.
std::vector<bool> fromBehind(Random& random) {
    const Plate plate(0.5, {0.3, 0.2, random.uniform(0.5, 2)});
    const Vec3 wi = Vec3(random.uniform(-1, 1), random.uniform(-1, 1), -1).normalized();
    const PhotonMap map(onDisc(random, 300, 1, wi));
    return within(0, 0,
                  {textbookRadiance(map, plate.at, 50, infinity).x(),
                   map.radiance(plate.at, {.nearest = 50, .radius = 0.5}).x()});
}

}  // namespace

std::vector<FailureRow> failureRows(const FailureTrials& trials) {
    const TriedMethod everything = {"all light from the map"};
    const TriedMethod sampled = {"direct light sampled", true};
    const TriedMethod textbook = {"textbook density"};
    const TriedMethod ours = {"this chapter's density", true};
    return countFailures(
        {{"edge: within a centimetre of a table's edge", {everything, sampled}, tableEdge},
         {"corner: on a floor within a centimetre of a wall", {everything, sampled}, corner},
         {"leak: in the dark behind a thin wall",
          {everything, {"indirect light looked up"}, {"final gather", true}},
          thinWall},
         {"blur: in the dark beside a caustic",
          {{"40 nearest photons"}, {"photons within 1.5 cm", true}},
          besideCaustic},
         {"specular–diffuse–specular: a spot by a mirror and seen in it",
          {{"path tracing with MIS"}, {"bidirectional path tracing"}, {"photon mapping", true}},
          causticInMirror},
         {"lamp in glass: a floor under it", {{"path tracing with MIS"}, {"photon mapping", true}}, lampInGlass},
         {"wrong side: a plate lit from behind", {textbook, ours}, fromBehind},
         {"fewer photons than k", {textbook, ours}, fewerThanK},
         {"one photon at the very place", {textbook, ours}, onePhoton},
         {"no photon within reach", {textbook, ours}, noPhoton}},
        trials);
}

void chartFailures(FigureContext& context) {
    drawFailureBars(failureRows(FailureTrials::of(context, context.byQuality(200, 1000))), context);
}

}  // namespace caustic
