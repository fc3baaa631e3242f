#include "failures/failure_kinds.h"

#include <cmath>
#include <numbers>

#include "camera/box_filter.h"
#include "camera/pinhole_camera.h"
#include "failures/synthetic.h"
#include "integrator/adaptive.h"
#include "light/cone_light.h"
#include "modeler/objects.h"
#include "sampling/emission_sampler.h"
#include "sampling/independent_sampler.h"

namespace caustic {

Scene emptyPicture(int width, int height) {
    return Scene({{},
                  {},
                  Color::Zero(),
                  std::make_shared<PinholeCamera>(Vec3::Zero(), Vec3::UnitZ(), Vec3::UnitY(), 1, width, height)});
}

namespace {

constexpr Real pi = std::numbers::pi;

// Numbers of a grid for one pair of dimensions alone.
class OnePairOnly final : public Sampler {
public:
    OnePairOnly(const Sampler& grid, const Sampler& rest, Dimension dimension)
        : grid_(grid), rest_(rest), dimension_(dimension) {}
    Real number(const PathName& path, Dimension dimension) const override { return rest_.number(path, dimension); }
    Vec2 pair(const PathName& path, Dimension dimension) const override {
        return (dimension.index == dimension_.index ? grid_ : rest_).pair(path, dimension);
    }

private:
    const Sampler& grid_;
    const Sampler& rest_;
    Dimension dimension_;
};

// Photons of a cone light in a wedge of it. The numbers of the place, which a lamp at a point has no use for, are
// spread evenly; or those of the direction.
std::vector<bool> wrongDimension(Random& random) {
    const ConeLight light(Vec3(0, 1, 0), -Vec3::UnitY(), random.uniform(0.1, 1.2), Color::Ones());
    const Real start = random.uniform(-pi, pi);
    const Real width = random.uniform(0.3 * pi, 1.7 * pi);
    const std::uint64_t seed = random.below(1U << 30);
    const EmissionSampler grid(seed, 10, 50, CellPlace::Jittered);
    const IndependentSampler plain(seed + 1);
    const auto share = [&](const Sampler& sampler) {
        int within = 0;
        for (int i = 0; i < 500; ++i) {
            const PathNumbers numbers = sampler.start(2, {0, 0}, i);
            const auto photon = light.sampleEmission(numbers.pair(Dimension::emissionPoint()),
                                                     numbers.pair(Dimension::emissionDirection()));
            const Vec3 to = photon->ray.direction;
            within += std::fmod(std::atan2(to.z(), to.x()) - start + 4 * pi, 2 * pi) < width;
        }
        return within / 500.0;
    };
    return within(0.022, width / (2 * pi),
                  {share(OnePairOnly(grid, plain, Dimension::emissionPoint())),
                   share(OnePairOnly(grid, plain, Dimension::emissionDirection())), share(grid)});
}

// Stripes about as fine as the grid that samples a pixel of them: their mean is 0.
std::vector<bool> aliasing(Random& random) {
    constexpr int cells = 12;
    const Real stripes = cells * (1.0 + static_cast<Real>(random.below(4))) + random.uniform(-0.3, 0.3);
    const Real phase = random.uniform(0, 2 * pi);
    const std::uint64_t seed = random.below(1U << 30);
    const Real truth = (std::sin(2 * pi * stripes + phase) - std::sin(phase)) / (2 * pi * stripes);
    const auto mean = [&](CellPlace place) {
        const EmissionSampler sampler(seed, cells, cells, place);
        Real sum = 0;
        for (int i = 0; i < cells * cells; ++i)
            sum += std::cos(2 * pi * stripes * sampler.start(0, {0, 0}, i).pair(Dimension::film()).x() + phase);
        return sum / (cells * cells);
    };
    return within(0.4, truth, {mean(CellPlace::Centre), mean(CellPlace::Jittered), mean(CellPlace::Offset)});
}

Real brightness(const Rendering& rendering) {
    Real sum = 0;
    for (int y = 0; y < rendering.film.height(); ++y) {
        for (int x = 0; x < rendering.film.width(); ++x) sum += rendering.film.value({x, y}).x();
    }
    return sum / (rendering.film.width() * rendering.film.height());
}

// Pixels that a bright path meets one time in 3 to 8, as behind a hole in the leaves. Those that have met none so far
// look finished.
std::vector<bool> stoppedEarly(Random& random) {
    constexpr int side = 16;
    static const Scene scene = emptyPicture(side, side);
    const BoxFilter filter;
    const Real chance = random.uniform(0.12, 0.33);
    const IndependentSampler sampler(random.below(1U << 30));
    const auto found = [&](const AdaptiveSettings& settings) {
        SyntheticIntegrator inner(scene, sampler, filter,
                                  [chance](const Vec2&, Real number) { return number < chance ? 1 / chance : 0; });
        const IntervalRule rule(0.2);
        AdaptiveIntegrator adaptive(inner, sampler, rule, settings);
        return brightness(renderAdaptively(adaptive, {.passes = 200}));
    };
    return within(0.2, 1,
                  {found({.batch = 1, .first = 4, .most = 64, .share = 1, .spread = 0}),
                   found({.batch = 4, .first = 32, .most = 64, .share = 1, .spread = 0}),
                   found({.batch = 4, .first = 32, .most = 64, .share = 1, .spread = 0, .apart = true})});
}

// The wire as a thing, in front of the camera.
Scene withWire(const Scene& scene, Real left, Real right) {
    const auto place = [&](Real x, Real y) -> Vec3 {
        const Ray ray = scene.camera().sampleRay({x, y}, {0.5, 0.5});
        return ray.origin + ray.direction / ray.direction.z();
    };
    SceneDescription wire;
    const Vec3 corner = place(left, -1);
    wire.objects = {diffuseRectangle(corner, place(right, -1) - corner, place(left, 9) - corner, Color::Ones())};
    wire.camera = std::make_shared<PinholeCamera>(Vec3::Zero(), Vec3::UnitZ(), Vec3::UnitY(), 1, scene.camera().width(),
                                                  scene.camera().height());
    return Scene(wire);
}

// A bright wire across the picture, a tenth to a fifth of a pixel thick. Right when each pixel that it crosses has got
// further paths.
std::vector<bool> thinFeature(Random& random) {
    constexpr int side = 8;
    static const Scene scene = emptyPicture(side, side);
    const BoxFilter filter;
    const IndependentSampler sampler(random.below(1U << 30));
    const Real thick = random.uniform(0.1, 0.2);
    const Real at = 3 + random.uniform(0, 1 - thick);
    const auto right = [&](const AdaptiveRule& rule, int spread) {
        SyntheticIntegrator inner(scene, sampler, filter, [&](const Vec2& film, Real) {
            return film.x() >= at && film.x() < at + thick ? 20 : 1;
        });
        const AdaptiveSettings settings = {
            .batch = 4, .first = 16, .paths = std::int64_t{64} * side * side, .share = 0.5, .spread = spread};
        AdaptiveIntegrator adaptive(inner, sampler, rule, settings);
        renderAdaptively(adaptive, {});
        for (int y = 0; y < side; ++y) {
            if (adaptive.paths({3, y}) <= settings.first) return false;
        }
        return true;
    };
    RayCounts counts;
    const HashRule hash(withWire(scene, at, at + thick), 4, 1, counts);
    const EdgeRule edge(0.15);
    const IntervalRule interval(0.05);
    return {right(hash, 0), right(edge, 0), right(edge, 1), right(interval, 1)};
}

}  // namespace

std::vector<FailureKind> samplingFailures() {
    return {{"wrong dimension: photons in a wedge of a cone light, off by more than 2.2 %",
             {{"grid for the place of emission", false}, {"grid for the direction", true}, {"grid for both", true}},
             wrongDimension},
            {"aliasing: stripes as fine as the grid, mean off by more than 0.4",
             {{"plain grid", false}, {"jittered grid", true}, {"grid with offsets", true}},
             aliasing},
            {"stopped early: bright paths are few, mean off by more than 20 %",
             {{"③ from 4 paths on", false},
              {"③ from 32 paths on, in batches of 4", true},
              {"③ decided by paths that don't count", true}},
             stoppedEarly},
            {"thin wire: a pixel that it crosses gets no further paths",
             {{"① path hash by corners", false},
              {"② edges", false},
              {"② edges, spread to neighbours", true},
              {"③ interval, spread to neighbours", true}},
             thinFeature}};
}

}  // namespace caustic
