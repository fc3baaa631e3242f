#include "integrator/adaptive.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "core/check.h"
#include "core/not_implemented.h"

namespace caustic {

namespace {

const AdaptiveSettings& checked(const AdaptiveSettings& settings) {
    const auto check = [](bool holds, const std::string& what, const std::string& value, const std::string& reason) {
        checkArgument(holds, "adaptive sampling's " + what, value, reason);
    };
    check(settings.batch >= 1, "batch", std::to_string(settings.batch), "must be at least 1");
    check(settings.first >= 1, "first paths", std::to_string(settings.first), "must be at least 1");
    check(settings.most >= settings.first, "most paths", std::to_string(settings.most),
          "must be at least the first ones");
    check(settings.paths >= 1, "paths in all", std::to_string(settings.paths), "must be at least 1");
    check(settings.share > 0 && settings.share <= 1, "share", formatReal(settings.share), "must be in (0, 1]");
    check(settings.spread >= 0, "spread", std::to_string(settings.spread), "must be at least 0");
    return settings;
}

}  // namespace

AdaptiveIntegrator::AdaptiveIntegrator(Integrator& inner, const Sampler& sampler, const AdaptiveRule& rule,
                                       const AdaptiveSettings& settings)
    : Integrator(inner.scene(), sampler, inner.filter()),
      inner_(&inner),
      rule_(&rule),
      settings_(checked(settings)),
      estimates_(inner.scene().camera().width(), inner.scene().camera().height()),
      given_(estimates_.size(), 0) {}

std::vector<PathId> AdaptiveIntegrator::next() const {
    //! [ex-10.7]
    const bool starting = std::ranges::any_of(given_, [&](std::int64_t n) { return n < settings_.first; });
    const std::vector<Real> wanted =
        starting ? std::vector<Real>(given_.size(), 1) : spreadOut(rule_->wanted(estimates_));
    std::vector<std::size_t> chosen;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        const bool room = starting ? given_[i] < settings_.first : given_[i] + settings_.batch <= settings_.most;
        if (wanted[i] > 0 && room) chosen.push_back(i);
    }
    // Those that want it most; the first of equals.
    auto most = static_cast<std::size_t>(std::max<std::int64_t>(0, settings_.paths - paths()) / settings_.batch);
    if (!starting)
        most = std::min(most, static_cast<std::size_t>(std::ceil(settings_.share * static_cast<Real>(wanted.size()))));
    if (chosen.size() > most) {
        std::ranges::stable_sort(chosen, [&](std::size_t a, std::size_t b) { return wanted[a] > wanted[b]; });
        chosen.resize(most);
        std::ranges::sort(chosen);
    }
    std::vector<PathId> next;
    for (const std::size_t i : chosen) {
        const Pixel pixel = {static_cast<int>(i) % estimates_.width(), static_cast<int>(i) / estimates_.width()};
        for (int k = 0; k < settings_.batch; ++k) next.push_back({pixel, given_[i] + k});
    }
    return next;
    //! [ex-10.7]
}

Rendering AdaptiveIntegrator::runPass(const Pass& pass, int threads) {
    //! [ex-10.8]
    Rendering rendering = inner_->runPass(pass, threads);
    const bool decides = !settings_.apart || pass.number % 2 == 0;
    for (std::size_t i = 0; i < pass.paths.size(); ++i) {
        const Pixel pixel = pass.paths[i].pixel;
        const std::size_t at = offset(pixel);
        ++given_[at];
        // Once for each batch, whose paths stand together.
        const bool last = i + 1 == pass.paths.size() || !(pass.paths[i + 1].pixel == pixel);
        if (last && decides && rendering.film.samples(pixel) > 0) estimates_[at].add(rendering.film.value(pixel));
    }
    if (settings_.apart && decides) rendering.film = Film(rendering.film.width(), rendering.film.height());
    return rendering;
    //! [ex-10.8]
}

Color AdaptiveIntegrator::Li(const Ray& ray, const MediumStack& media, const PathNumbers& numbers,
                             RayCounts& counts) const {
    return inner_->Li(ray, media, numbers, counts);
}

std::int64_t AdaptiveIntegrator::paths() const {
    return std::accumulate(given_.begin(), given_.end(), std::int64_t{0});
}

// The largest number of the square of pixels around each: along rows, then along columns.
std::vector<Real> AdaptiveIntegrator::spreadOut(const std::vector<Real>& wanted) const {
    const int width = estimates_.width();
    const int height = estimates_.height();
    const auto largestAlong = [&](const std::vector<Real>& from, int stepX, int stepY) {
        std::vector<Real> to(from.size());
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                Real largest = 0;
                for (int k = -settings_.spread; k <= settings_.spread; ++k) {
                    const Pixel near = {std::clamp(x + k * stepX, 0, width - 1),
                                        std::clamp(y + k * stepY, 0, height - 1)};
                    largest = std::max(largest, from[offset(near)]);
                }
                to[offset({x, y})] = largest;
            }
        }
        return to;
    };
    return settings_.spread == 0 ? wanted : largestAlong(largestAlong(wanted, 1, 0), 0, 1);
}

void AdaptiveIntegrator::save(ByteWriter& to) const {
    for (std::size_t i = 0; i < estimates_.size(); ++i) {
        const PixelEstimate& one = estimates_[i];
        to.put(std::array{given_[i], one.batches});
        to.put(std::array{one.mean.x(), one.mean.y(), one.mean.z(), one.squares.x(), one.squares.y(), one.squares.z()});
    }
    inner_->save(to);
}

void AdaptiveIntegrator::load(ByteReader& from) {
    PixelEstimates estimates(estimates_.width(), estimates_.height());
    std::vector<std::int64_t> given(given_.size());
    for (std::size_t i = 0; i < given.size(); ++i) {
        const auto counts = from.get<std::array<std::int64_t, 2>>();
        const auto values = from.get<std::array<Real, 6>>();
        for (const std::int64_t count : counts) {
            if (count < 0) from.refuse(std::to_string(count), "is no number of paths");
        }
        for (const Real value : values) {
            if (!std::isfinite(value)) from.refuse(formatReal(value), "isn't what a pixel keeps");
        }
        given[i] = counts[0];
        estimates[i] = {counts[1], {values[0], values[1], values[2]}, {values[3], values[4], values[5]}};
    }
    inner_->load(from);
    given_ = std::move(given);
    estimates_ = std::move(estimates);
}

Rendering renderAdaptively(AdaptiveIntegrator& integrator, RenderSettings settings) {
    settings.choose = [&integrator](const Rendering&) { return integrator.next(); };
    return render(integrator, settings);
}

}  // namespace caustic
