#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numeric>
#include <vector>

#include "camera/pinhole_camera.h"
#include "core/random.h"
#include "integrator/density_walk.h"
#include "integrator/light_choice.h"
#include "integrator/path_density.h"
#include "integrator/power_heuristic.h"
#include "integrator/walk.h"
#include "light/cone_light.h"
#include "light/constant_environment.h"
#include "light/point_light.h"
#include "material/diffuse_material.h"
#include "material/mirror_material.h"
#include "material/phong_material.h"
#include "material/refraction_material.h"
#include "sampling/independent_sampler.h"
#include "shape/box.h"
#include "shape/rectangle.h"
#include "shape/sphere.h"
#include "texture/constant_texture.h"

namespace caustic {
namespace {

const IndependentSampler sampler(3);

// A vertex of a whole path as the weights see it, whichever strategy made the path.
struct Vertex {
    bool delta = false;  // scatters into one direction only
    Real toEye = 1;      // density over solid angle towards the eye, when the path comes from the light
    Real toLight = 1;    // the other way round
    Segment segment;     // to the next vertex towards the eye
};

// From the light, vertex 0, to the pinhole, the last one.
struct WholePath {
    std::vector<Vertex> vertices;
    Real light = 1;        // density of vertex 0 when a walk starts there
    bool canBeHit = true;  // the light, by chance
    bool onFilm = true;
};

Segment turned(const Segment& segment) { return {segment.cosTo, segment.cosFrom, segment.squaredDistance}; }

VertexPdf towardsEye(const Vertex& v) { return {v.toEye, v.toLight, !v.delta}; }
VertexPdf towardsLight(const Vertex& v) { return {v.toLight, v.toEye, !v.delta}; }

// Density over area with which a walk from the eye picks vertex i, and one from the light.
Real byEye(const WholePath& path, std::size_t i) {
    const Segment& way = path.vertices[i].segment;
    return path.vertices[i + 1].toLight * way.cosFrom / way.squaredDistance;
}
Real byLight(const WholePath& path, std::size_t i) {
    if (i == 0) return path.light;
    const Segment& way = path.vertices[i - 1].segment;
    return path.vertices[i - 1].toEye * way.cosTo / way.squaredDistance;
}

// Whether s vertices may come from the light.
bool possible(const WholePath& path, std::size_t s) {
    const std::size_t last = path.vertices.size() - 1;
    if (s == 0) return path.canBeHit;
    if (s == last && !path.onFilm) return false;
    return s <= last && !path.vertices[s - 1].delta && !path.vertices[s].delta;
}

// By the sums that are gathered along both walks.
std::vector<Real> weightsAlongWalks(const WholePath& path) {
    const std::size_t last = path.vertices.size() - 1;
    std::vector<PathDensity> fromLight(last + 1);
    fromLight[0] = PathDensity::start(path.light, path.canBeHit);
    for (std::size_t i = 0; i < last; ++i)
        fromLight[i + 1] = fromLight[i].next(towardsEye(path.vertices[i]), path.vertices[i].segment);
    std::vector<PathDensity> fromEye(last + 1);
    fromEye[last] = PathDensity::start(1, false);
    for (std::size_t i = last; i > 0; --i) {
        VertexPdf left = towardsLight(path.vertices[i]);
        if (i == last && !path.onFilm) left.connectible = false;
        fromEye[i - 1] = fromEye[i].next(left, turned(path.vertices[i - 1].segment));
    }
    std::vector<Real> weights;
    for (std::size_t s = 0; s <= last; ++s) {
        if (!possible(path, s)) continue;
        const Real light = s == 0 ? 0 : fromLight[s - 1].others(byEye(path, s - 1), path.vertices[s - 1].toLight);
        const Real eye = s == last ? 0 : fromEye[s].others(byLight(path, s), path.vertices[s].toEye);
        weights.push_back(strategyWeight(light, eye));
    }
    return weights;
}

// By the densities themselves: p_s = Π p_L(x_i) (i < s) · Π p_E(x_i) (i ≥ s), in logarithms. Source: Veach 10.2.
std::vector<Real> weightsByDensities(const WholePath& path) {
    const std::size_t last = path.vertices.size() - 1;
    std::vector<Real> logarithms;
    for (std::size_t s = 0; s <= last; ++s) {
        if (!possible(path, s)) continue;
        Real sum = 0;
        for (std::size_t i = 0; i < last; ++i) sum += std::log(i < s ? byLight(path, i) : byEye(path, i));
        logarithms.push_back(sum);
    }
    std::vector<Real> weights;
    for (const Real own : logarithms) {
        Real all = 0;
        for (const Real other : logarithms) all += std::exp(2 * (other - own));
        weights.push_back(1 / all);
    }
    return weights;
}

// Makes whole paths of what a walk from the eye meets: lights that it hits, and those that its vertices ask for.
class PathMaker {
public:
    PathMaker(const Scene& scene, const LightChoice& lights, const Ray& eye, Random& random,
              std::vector<WholePath>& paths)
        : scene_(scene), lights_(lights), random_(random), paths_(paths) {
        const Real pdfW = scene.camera().pdf(eye).pdfW;
        onFilm_ = pdfW > 0;
        fromEye_.push_back({false, 1, onFilm_ ? pdfW : 1, {}});
        places_.push_back(eye.origin);
    }

    bool reached(const Interaction& at, const WalkState& path) {
        const Real squared = (at.hit().point - places_.back()).squaredNorm();
        // Seen from the light's side, the segment leads from here to the vertex before.
        here_ = {false, 1, 1, {at.geometricCosine(at.wo()), cosBefore_, squared}};
        places_.push_back(at.hit().point);
        if (at.light() != nullptr && (at.Le() > 0).any() && path.length > 1) {
            const EmissionPdf pdf = at.light()->pdfEmission(at.hit(), at.wo());
            Vertex end = here_;
            end.toEye = pdf.pdfW;
            finish(end, lights_.probability(*at.light()) * pdf.pdfA, true);
        }
        if (at.bsdf() == nullptr) return false;
        if (anyOf(at.bsdf()->lobes(), LobeFlags::Diffuse | LobeFlags::Glossy)) askFor(at);
        return true;
    }

    void scattered(const Interaction& at, const BsdfSample& sample) { leave(at, sample.wi, sample.delta()); }

    void escaped(const WalkState& path) {
        if (path.length == 1) return;
        for (const ChosenLight& one : lights_.infinite()) {
            const EmissionPdf pdf = one.light->pdfEmission({}, -path.ray.direction);
            finish({false, pdf.pdfA, 1, {1, cosBefore_, 1}}, one.probability * pdf.pdfW, true);
        }
    }

private:
    // Adds the vertex that the walk is at, going on along wi.
    void leave(const Interaction& at, const Vec3& wi, bool delta) {
        Vertex v = here_;
        v.delta = delta;
        v.toLight = delta ? 1 : at.bsdf()->pdfW(at.wo(), wi);
        v.toEye = delta ? 1 : at.bsdf()->pdfW(wi, at.wo());
        fromEye_.push_back(v);
        cosBefore_ = at.geometricCosine(wi);
    }

    // A path that ends with a light at a point, which no walk hits.
    void askFor(const Interaction& at) {
        const auto chosen = lights_.choose(random_.uniform());
        const auto sample = chosen->light->sampleDirect(at.hit(), {0.5, 0.5});
        if (!sample || !chosen->light->deltaPlace() || at.bsdf()->pdfW(at.wo(), sample->wi) == 0) return;
        const EmissionPdf pdf = chosen->light->pdfEmission({}, -sample->wi);
        const Vertex here = here_;
        leave(at, sample->wi, false);
        finish({false, pdf.pdfW, 1, {1, cosBefore_, sample->ray.direction.squaredNorm()}}, chosen->probability, false);
        fromEye_.pop_back();
        here_ = here;
    }

    void finish(const Vertex& light, Real density, bool canBeHit) {
        WholePath path = {{light}, density, canBeHit, onFilm_};
        path.vertices.insert(path.vertices.end(), fromEye_.rbegin(), fromEye_.rend());
        paths_.push_back(path);
    }

    const Scene& scene_;
    const LightChoice& lights_;
    Random& random_;
    std::vector<WholePath>& paths_;
    std::vector<Vertex> fromEye_;
    std::vector<Vec3> places_;
    Vertex here_;
    Real cosBefore_ = 1;
    bool onFilm_ = true;
};

std::shared_ptr<const Texture> shining(Real radiance) {
    return std::make_shared<ConstantTexture>(Color::Constant(radiance));
}

// A room with everything: diffuse, glossy, mirror, glass; lights with an extent, at a point, a cone, from infinity.
SceneDescription everything() {
    const auto diffuse = std::make_shared<DiffuseMaterial>(Color(0.7, 0.5, 0.9));
    const auto glossy = std::make_shared<PhongMaterial>(shining(0.3), Color::Constant(0.6), 200);
    const auto glass = std::make_shared<RefractionMaterial>(Color::Constant(0.2), Color::Constant(0.8));
    const auto wall = [&](const Vec3& corner, const Vec3& u, const Vec3& v) {
        return SceneObject{.shape = std::make_shared<Rectangle>(corner, u, v), .material = diffuse};
    };
    SceneDescription room;
    room.objects = {
        wall({-1, -1, -1}, {0, 0, 2}, {2, 0, 0}),
        wall({-1, -1, -1}, {0, 2, 0}, {0, 0, 2}),
        wall({1, -1, -1}, {0, 0, 2}, {0, 2, 0}),
        {.shape = std::make_shared<Rectangle>(Vec3(-1, -1, -1), Vec3(2, 0, 0), Vec3(0, 2, 0)), .material = glossy},
        {.shape = std::make_shared<Sphere>(Vec3(-0.4, -0.6, 0), 0.4),
         .material = std::make_shared<MirrorMaterial>(Color::Ones())},
        {.shape = std::make_shared<Sphere>(Vec3(0.5, -0.6, 0.2), 0.35),
         .material = glass,
         .interior = Interior{1.5, nullptr, 0}},
        {.shape = std::make_shared<Rectangle>(Vec3(-0.3, 0.9, -0.3), Vec3(0.6, 0, 0), Vec3(0, 0, 0.6)),
         .material = diffuse,
         .emission = shining(9)}};
    room.lights = {std::make_shared<PointLight>(Vec3(0.3, 0.5, 0.8), Color::Ones()),
                   std::make_shared<ConeLight>(Vec3(-0.7, 0.8, 0.3), Vec3(0.3, -1, 0), 0.8, Color::Constant(4)),
                   std::make_shared<ConstantEnvironment>(Color::Constant(0.3))};
    room.camera = std::make_shared<PinholeCamera>(Vec3(0.1, 0, 3.4), Vec3(0, 0, 0), Vec3::UnitY(), 0.7, 32, 32);
    return room;
}

// The weights of all strategies that can make a path sum to 1, and each is what the densities say: 10⁶ random paths of
// a room with everything.
TEST(Weights, SumToOneAndAreThoseOfTheDensities) {
    const Scene scene(everything());
    const LightChoice lights(scene.lights());
    const PathLimits limits = {.maxLength = 12, .rouletteStart = 4};
    RayCounts counts;
    std::int64_t paths = 0;
    std::int64_t manyWays = 0;
    Real worstSum = 0;
    Real worstWeight = 0;
    for (std::uint64_t i = 0; paths < 1'000'000; ++i) {
        Random random(5, {i});
        // A few film points lie outside, where wide pixel filters reach.
        const Ray eye = scene.camera().sampleRay({random.uniform(-0.5, 32.5), random.uniform(-0.5, 32.5)}, {0.5, 0.5});
        std::vector<WholePath> found;
        PathMaker maker(scene, lights, eye, random, found);
        walk(scene, {eye, {}, Color::Ones()}, TransportMode::Radiance, limits,
             sampler.start(0, {0, 0}, static_cast<std::int64_t>(i)), counts, maker);
        for (const WholePath& path : found) {
            const std::vector<Real> weights = weightsAlongWalks(path);
            const std::vector<Real> expected = weightsByDensities(path);
            if (weights.empty()) continue;  // no strategy can make it: light at a point, seen over delta lobes only
            const Real sum = std::accumulate(weights.begin(), weights.end(), Real(0));
            worstSum = std::max(worstSum, std::isfinite(sum) ? std::abs(sum - 1) : 1);
            for (std::size_t k = 0; k < weights.size(); ++k)
                worstWeight = std::max(worstWeight, std::abs(weights[k] - expected[k]));
            ++paths;
            if (weights.size() > 2) ++manyWays;
        }
    }
    EXPECT_LE(worstSum, 1e-12);
    EXPECT_LE(worstWeight, 1e-11);
    EXPECT_GE(manyWays, paths / 3);
}

// With two strategies the weights are those of path tracing.
TEST(Weights, OfTwoStrategiesAreThePowerHeuristic) {
    for (std::uint64_t i = 0; i < 1000; ++i) {
        Random random(6, {i});
        const Real byChance = std::exp(random.uniform(-30, 30));
        const Real sampled = std::exp(random.uniform(-30, 30));
        const PathDensity light = PathDensity::start(sampled, true);
        EXPECT_NEAR(strategyWeight(light.others(byChance, 0), 0), powerHeuristic(sampled, byChance), 1e-14);
        EXPECT_NEAR(powerHeuristic(sampled, byChance) + powerHeuristic(byChance, sampled), 1, 1e-14);
    }
    EXPECT_EQ(powerHeuristic(1, 0), 1);
    EXPECT_EQ(powerHeuristic(1e-200, 1e200), 0);
}

}  // namespace
}  // namespace caustic
