#include "measures/adaptive_points.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/parallel.h"
#include "core/progress.h"
#include "sampling/independent_sampler.h"

namespace caustic {

namespace {

constexpr Real noisiest = 0.02;  // share of the pixels

struct Taken {
    Image picture{1, 1};
    double seconds = 0;
    Real paths = 0;
};

Taken take(const Study& study, const Scene& scene, const Taking& way, std::uint64_t seed) {
    const IndependentSampler sampler(seed);
    const auto inner = study.method(scene, sampler);
    const Camera& camera = scene.camera();
    const Real pixels = static_cast<Real>(camera.width()) * camera.height();
    if (!way.rule) {
        const Rendering rendering = render(*inner, {.passes = way.passes});
        requireFinite(rendering);
        return {rendering.film.image(), rendering.seconds, static_cast<Real>(way.passes)};
    }
    const auto rule = way.rule(scene);
    AdaptiveIntegrator adaptive(*inner, sampler, *rule, way.settings);
    const Rendering rendering = renderAdaptively(adaptive, {});
    requireFinite(rendering);
    return {rendering.film.image(), rendering.seconds, static_cast<Real>(adaptive.paths()) / pixels};
}

Measurement meanOf(const std::vector<Real>& values) {
    const auto count = static_cast<Real>(values.size());
    const Real mean = std::accumulate(values.begin(), values.end(), 0.0) / count;
    Real squares = 0;
    for (const Real one : values) squares += (one - mean) * (one - mean);
    return {mean, std::sqrt(squares / (count * (count - 1)))};
}

// Of each pixel, the squared deviation of one picture from the mean of the others; (n − 1)/n of it has the variance for
// a mean.
std::vector<Real> deviations(const std::vector<Taken>& taken, std::size_t which) {
    const std::size_t values = taken[which].picture.data().size();
    const auto others = static_cast<Real>(taken.size() - 1);
    std::vector<Real> pixels(values / 3, 0);
    for (std::size_t i = 0; i < values; ++i) {
        Real mean = 0;
        for (std::size_t k = 0; k < taken.size(); ++k)
            mean += k == which ? 0 : Real(taken[k].picture.data()[i]) / others;
        const Real off = Real(taken[which].picture.data()[i]) - mean;
        pixels[i / 3] += off * off * others / (others + 1) / 3;
    }
    return pixels;
}

std::vector<std::size_t> noisiestPixels(const std::vector<Taken>& taken) {
    std::vector<Real> sums(taken[0].picture.data().size() / 3, 0);
    for (std::size_t k = 0; k < taken.size(); ++k) {
        const std::vector<Real> own = deviations(taken, k);
        for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += own[i];
    }
    std::vector<std::size_t> order(sums.size());
    std::iota(order.begin(), order.end(), 0);
    std::ranges::sort(order, [&](std::size_t a, std::size_t b) { return sums[a] > sums[b]; });
    order.resize(static_cast<std::size_t>(std::ceil(noisiest * static_cast<Real>(order.size()))));
    return order;
}

PictureNoise noiseOf(const std::vector<Taken>& taken, const std::vector<std::size_t>& worst) {
    std::vector<Real> variances;
    std::vector<Real> worsts;
    std::vector<Real> means;
    PictureNoise noise;
    for (std::size_t k = 0; k < taken.size(); ++k) {
        const std::vector<Real> own = deviations(taken, k);
        variances.push_back(std::accumulate(own.begin(), own.end(), 0.0) / static_cast<Real>(own.size()));
        Real sum = 0;
        for (const std::size_t i : worst) sum += own[i];
        worsts.push_back(sum / static_cast<Real>(worst.size()));
        const auto data = taken[k].picture.data();
        means.push_back(std::accumulate(data.begin(), data.end(), 0.0) / static_cast<Real>(data.size()));
        noise.seconds += taken[k].seconds / static_cast<double>(taken.size());
        noise.paths += taken[k].paths / static_cast<Real>(taken.size());
    }
    noise.variance = meanOf(variances);
    noise.worst = meanOf(worsts);
    noise.mean = meanOf(means);
    return noise;
}

}  // namespace

std::vector<PictureNoise> noiseOf(const Study& study, int width, const std::vector<Taking>& ways, int seeds,
                                  FigureContext& context) {
    const Scene scene = study.scene(assetOf(study, context), width);
    const auto perWay = static_cast<std::size_t>(seeds);
    std::vector<std::vector<Taken>> taken(ways.size(), std::vector<Taken>(perWay));
    parallelFor(static_cast<std::int64_t>(ways.size() * perWay), context.threads(), [&](std::int64_t item) {
        const auto at = static_cast<std::size_t>(item);
        taken[at / perWay][at % perWay] =
            take(study, scene, ways[at / perWay], context.seed() + 1000 * static_cast<std::uint64_t>(item));
    });
    const std::vector<std::size_t> worst = noisiestPixels(taken[0]);
    std::vector<PictureNoise> noises;
    for (const std::vector<Taken>& own : taken) noises.push_back(noiseOf(own, worst));
    return noises;
}

std::vector<Taking> waysToTake(std::int64_t paths, bool all) {
    std::vector<Taking> ways = {{"uniform", {}, {}, paths}};
    const auto add = [&](const std::string& method, std::function<std::unique_ptr<AdaptiveRule>(const Scene&)> rule) {
        ways.push_back({method, std::move(rule), {.batch = 4, .first = 16, .share = 0.1}, paths});
    };
    if (all) {
        add("① path hash", [](const Scene& scene) {
            RayCounts counts;
            return std::make_unique<HashRule>(scene, 12, 1, counts);
        });
        add("② edges", [](const Scene&) { return std::make_unique<EdgeRule>(0.04); });
    }
    // As tight as paths last: those with the widest intervals come first.
    add("③ widest interval", [](const Scene&) { return std::make_unique<IntervalRule>(1e-6); });
    add("largest gain", [](const Scene&) { return std::make_unique<GainRule>(); });
    add("largest gain apart", [](const Scene&) { return std::make_unique<GainRule>(); });
    ways.back().settings.apart = true;
    return ways;
}

Measurement ratio(const Measurement& one, const Measurement& other) {
    const Real value = one.value / other.value;
    return {value, value * std::hypot(one.error / one.value, other.error / other.value)};
}

std::vector<AdaptivePoint> adaptivePoints(FigureContext& context) {
    struct Job {
        std::string scene;
        int width;
        std::vector<std::int64_t> paths;
        bool all;
    };
    const bool report = context.quality() == Quality::Report;
    std::vector<Job> jobs = {{"bunny", 24, {32}, true}};
    if (report) jobs = {{"bunny", 48, {32, 128}, true}, {"box", 48, {64}, true}, {"cup", 24, {32}, false}};
    constexpr int seeds = 4;
    context.progress().expect(static_cast<std::int64_t>(jobs.size()));
    std::vector<AdaptivePoint> points;
    for (const Job& job : jobs) {
        const Study& what = study(job.scene);
        const auto pixels = static_cast<std::int64_t>(job.width) * std::lround(what.aspect * job.width);
        for (const std::int64_t paths : job.paths) {
            std::vector<Taking> ways = waysToTake(paths, job.all);
            for (Taking& way : ways) way.settings.paths = paths * pixels;
            const std::vector<PictureNoise> noises = noiseOf(what, job.width, ways, seeds, context);
            for (std::size_t i = 0; i < ways.size(); ++i) {
                const PictureNoise& own = noises[i];
                const Measurement gain = ratio(noises[0].variance, own.variance);
                const Real slower = noises[0].seconds / own.seconds;
                const Measurement share = ratio(own.mean, noises[0].mean);
                points.push_back({job.scene,
                                  ways[i].method,
                                  paths,
                                  own,
                                  gain,
                                  {gain.value * slower, gain.error * slower},
                                  ratio(noises[0].worst, own.worst),
                                  {share.value - 1, share.error}});
            }
        }
        context.progress().advance();
    }
    return points;
}

}  // namespace caustic
