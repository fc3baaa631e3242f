#include "integrator/sppm.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "core/check.h"
#include "core/not_implemented.h"
#include "core/parallel.h"
#include "integrator/direct_at_point.h"

namespace caustic {

namespace {

constexpr std::size_t pathsPerItem = 64;  // so that threads have something to do between asking for more

SppmSettings checked(SppmSettings settings, const Scene& scene) {
    checkLimits(settings.limits);
    checkArgument(settings.alpha > 0 && settings.alpha < 1, "alpha", formatReal(settings.alpha),
                  "must be between 0 and 1, both excluded");
    checkArgument(std::isfinite(settings.radius) && settings.radius >= 0, "radius", formatReal(settings.radius),
                  "must be greater than 0, or 0 for the usual one");
    checkArgument(settings.photons >= 1, "photons a pass", std::to_string(settings.photons), "must be at least 1");
    if (settings.radius == 0) settings.radius = usualRadius(scene);
    return settings;
}

Real discArea(Real radius) { return std::numbers::pi * radius * radius; }

}  // namespace

Real usualRadius(const Scene& scene) {
    constexpr Real share = 0.023;
    return scene.bounds().isEmpty() ? share : share * scene.bounds().diagonal().norm() / 2;
}

Sppm::Sppm(const Scene& scene, const Sampler& sampler, const PixelFilter& filter, const SppmSettings& settings)
    : Integrator(scene, sampler, filter),
      settings_(checked(settings, scene)),
      lights_(scene.lights()),
      radius_(settings_.radius) {
    if (settings_.rule == RadiusRule::Pass) return;
    const Camera& camera = scene.camera();
    pixels_.assign(static_cast<std::size_t>(camera.width()) * static_cast<std::size_t>(camera.height()),
                   {{radius_, 0, Color::Zero()}, 0});
}

Rendering Sppm::runPass(const Pass& pass, int threads) {
    //! [ex-09.8]
    const Camera& camera = scene().camera();
    Rendering rendering = {Film(camera.width(), camera.height()), {}, 1, 0};
    if (settings_.rule == RadiusRule::Pass) radius_ = radiusOfPass(settings_.radius, settings_.alpha, pass.number);
    traceNewPhotons(pass.number, threads, rendering.counts);

    std::vector<Found> found(pass.paths.size());
    std::vector<RayCounts> counts((found.size() + pathsPerItem - 1) / pathsPerItem);
    parallelFor(static_cast<std::int64_t>(counts.size()), threads, [&](std::int64_t item) {
        const auto at = static_cast<std::size_t>(item);
        const std::size_t end = std::min(found.size(), (at + 1) * pathsPerItem);
        for (std::size_t i = at * pathsPerItem; i < end; ++i) found[i] = look(pass.paths[i], counts[at]);
    });
    for (const RayCounts& own : counts) rendering.counts += own;

    for (std::size_t i = 0; i < found.size(); ++i) {
        Color value = found[i].direct;
        if (settings_.rule == RadiusRule::Pass) value += found[i].photons.flux / discArea(radius_);
        rendering.film.add(pass.paths[i].pixel, pass.paths[i].index, value);
    }
    if (settings_.rule == RadiusRule::Point) updateStatistics(pass, found);
    return rendering;
    //! [ex-09.8]
}

void Sppm::traceNewPhotons(std::int64_t pass, int threads, RayCounts& counts) {
    photons_.reset();
    if (!whyNoPhotons().empty()) return;
    PhotonSettings settings = {.limits = settings_.limits, .splits = 0, .direct = false};
    --settings.limits.maxLength;  // one segment is the eye's
    const std::int64_t first = pass * settings_.photons;
    photons_.emplace(tracePhotons(scene(), lights_, sampler(), settings, first, settings_.photons, threads, counts),
                     radius_);
}

std::string Sppm::whyNoPhotons() const {
    const SceneNeeds& needs = scene().needs();
    if (!lights_.choose(0)) return "no light shines, so there are no photons";
    if (!needs.diffuse && !needs.glossy) return "no surface spreads light, so photons would light nothing";
    // The shortest way: from the lamp over a surface to the point, and to the eye.
    if (settings_.limits.maxLength < 3) return "paths of less than 3 segments have no room for photons";
    return "";
}

Sppm::Found Sppm::look(const Ray& ray, const MediumStack& media, const PathNumbers& numbers, Real radius,
                       RayCounts& counts) const {
    //! [ex-09.7]
    const EyePath eye = findVisiblePoint(scene(), ray, media, settings_.limits, numbers, counts);
    Found found = {eye.seen, {}};
    if (!eye.point) return found;
    const VisiblePoint& point = *eye.point;
    if (point.length < settings_.limits.maxLength)
        found.direct += point.beta * directAtPoint(scene(), lights_, point, numbers, counts);
    if (photons_) found.photons = photons_->gather(point, radius, settings_.limits.maxLength);
    found.photons.flux *= point.beta;
    return found;
    //! [ex-09.7]
}

Sppm::Found Sppm::look(const PathId& path, RayCounts& counts) const {
    const PathNumbers numbers = sampler().start(eyeStream, path.pixel, path.index);
    const Real radius = settings_.rule == RadiusRule::Pass ? radius_ : pixels_[offset(path.pixel)].statistics.radius;
    return look(eyeRay(path, numbers, counts), scene().cameraMedia(), numbers, radius, counts);
}

Color Sppm::Li(const Ray& ray, const MediumStack& media, const PathNumbers& numbers, RayCounts& counts) const {
    const Found found = look(ray, media, numbers, radius_, counts);
    return found.direct + found.photons.flux / discArea(radius_);
}

void Sppm::updateStatistics(const Pass& pass, const std::vector<Found>& found) {
    std::vector<bool> seen(pixels_.size(), false);
    for (std::size_t i = 0; i < found.size(); ++i) {
        const std::size_t at = offset(pass.paths[i].pixel);
        checkArgument(!seen[at], "pass", std::to_string(pass.number), "has a pixel twice");
        seen[at] = true;
        ++pixels_[at].passes;
        update(pixels_[at].statistics, found[i].photons, settings_.alpha);
    }
    // The grid of the next pass suits what radius pixels have on average.
    Real squares = 0;
    for (const PixelState& pixel : pixels_) squares += pixel.statistics.radius * pixel.statistics.radius;
    radius_ = std::sqrt(squares / static_cast<Real>(pixels_.size()));
}

void Sppm::develop(Image& picture) const {
    if (settings_.rule == RadiusRule::Pass) return;
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
            const PixelState& pixel = pixels_[offset({x, y})];
            if (pixel.passes == 0) continue;
            const Real area = discArea(pixel.statistics.radius) * static_cast<Real>(pixel.passes);
            picture.set(x, y, picture.at(x, y) + pixel.statistics.flux / area);
        }
    }
}

void Sppm::save(ByteWriter& to) const {
    to.put(radius_);
    for (const PixelState& pixel : pixels_) {
        const PointStatistics& one = pixel.statistics;
        to.put(std::array<Real, 5>{one.radius, one.photons, one.flux.x(), one.flux.y(), one.flux.z()});
        to.put(pixel.passes);
    }
}

void Sppm::load(ByteReader& from) {
    const auto radius = from.get<Real>();
    if (!(radius > 0 && std::isfinite(radius))) from.refuse(formatReal(radius), "is no radius");
    std::vector<PixelState> pixels = pixels_;
    for (PixelState& pixel : pixels) {
        const auto one = from.get<std::array<Real, 5>>();
        pixel.passes = from.get<std::int64_t>();
        for (const Real value : one) {
            if (!(value >= 0 && std::isfinite(value))) from.refuse(formatReal(value), "isn't what a pixel keeps");
        }
        if (pixel.passes < 0) from.refuse(std::to_string(pixel.passes), "is no number of passes");
        pixel.statistics = {one[0], one[1], {one[2], one[3], one[4]}};
    }
    radius_ = radius;
    pixels_ = std::move(pixels);
}

std::size_t Sppm::offset(Pixel pixel) const {
    return static_cast<std::size_t>(pixel.y) * static_cast<std::size_t>(scene().camera().width()) +
           static_cast<std::size_t>(pixel.x);
}

}  // namespace caustic
