#include "integrator/volume_sppm.h"

#include <cmath>
#include <numbers>
#include <vector>

#include "core/check.h"
#include "core/not_implemented.h"
#include "integrator/direct_at_point.h"
#include "integrator/medium_light.h"
#include "integrator/radius_rule.h"
#include "integrator/sppm.h"
#include "integrator/volume_photons.h"
#include "integrator/walk.h"

namespace caustic {

namespace {

constexpr std::uint64_t mediumBranch = 32;  // the numbers of places in media

VolumeSppmSettings checked(VolumeSppmSettings settings, const Scene& scene) {
    checkLimits(settings.limits);
    checkArgument(settings.alpha > 0 && settings.alpha < 1, "alpha", formatReal(settings.alpha),
                  "must be between 0 and 1, both excluded");
    for (const Real radius : {settings.radius, settings.beamRadius})
        checkArgument(std::isfinite(radius) && radius >= 0, "radius", formatReal(radius),
                      "must be greater than 0, or 0 for the usual one");
    checkArgument(settings.photons >= 0, "photons a pass", std::to_string(settings.photons), "must be at least 0");
    checkArgument(settings.places >= 1, "places along a ray", std::to_string(settings.places), "must be at least 1");
    if (settings.radius == 0) settings.radius = usualRadius(scene);
    if (settings.beamRadius == 0) settings.beamRadius = settings.radius;
    return settings;
}

}  // namespace

VolumeSppm::VolumeSppm(const Scene& scene, const Sampler& sampler, const PixelFilter& filter,
                       const VolumeSppmSettings& settings)
    : Integrator(scene, sampler, filter),
      settings_(checked(settings, scene)),
      lights_(scene.lights()),
      radius_(settings_.radius),
      beamRadius_(settings_.beamRadius) {}

Rendering VolumeSppm::runPass(const Pass& pass, int threads) {
    radius_ = radiusOfPass(settings_.radius, settings_.alpha, pass.number);
    beamRadius_ = radiusOfPass(settings_.beamRadius, settings_.alpha, pass.number);
    RayCounts counts;
    traceNewPhotons(pass.number, threads, counts);
    Rendering rendering = Integrator::runPass(pass, threads);
    rendering.counts += counts;
    return rendering;
}

void VolumeSppm::traceNewPhotons(std::int64_t pass, int threads, RayCounts& counts) {
    onSurfaces_.reset();
    inMedia_.reset();
    if (!whyNoPhotons().empty()) return;
    PathLimits limits = settings_.limits;
    --limits.maxLength;  // one segment is the eye's
    const VolumePhotons photons = traceVolumePhotons(scene(), lights_, sampler(), limits, pass * settings_.photons,
                                                     settings_.photons, threads, counts);
    onSurfaces_.emplace(photons.onSurfaces, radius_);
    if (!photons.inMedia.empty()) inMedia_.emplace(photons.inMedia);
}

std::string VolumeSppm::whyNoPhotons() const {
    const SceneNeeds& needs = scene().needs();
    if (settings_.photons == 0) return "no photons are wished for";
    if (!lights_.choose(0)) return "no light shines, so there are no photons";
    if (!needs.diffuse && !needs.glossy && !needs.scattering)
        return "nothing spreads light, so photons would light nothing";
    if (settings_.limits.maxLength < (needs.scattering ? 2 : 3)) return "paths are too short to have room for photons";
    return "";
}

Color VolumeSppm::Li(const Ray& ray, const MediumStack& media, const PathNumbers& numbers, RayCounts& counts) const {
    //! [ex-11.8]
    Color sum = Color::Zero();
    WalkState path(ray, media, Color::Ones());
    std::vector<MediumSpan> spans;
    while (true) {
        Color passed;
        const auto at = scene().follow(path.ray, path.media, passed, spans, counts);
        ++path.length;
        for (std::size_t i = 0; i < spans.size(); ++i)
            sum += path.beta * spans[i].before * scatteredAlong(spans[i], path.length, i, numbers, counts);
        path.beta *= passed;
        if (!at) return sum + path.beta * scene().Le(path.ray);
        if (at->light() != nullptr) sum += path.beta * at->Le();
        if (!at->scatters()) return sum;
        if (at->connectible()) return sum + path.beta * atSurface({*at, path.beta, path.length}, numbers, counts);
        if (path.length >= settings_.limits.maxLength) return sum;
        if (!leaveVertex(path, *at, TransportMode::Radiance, settings_.limits, numbers)) return sum;
    }
    //! [ex-11.8]
}

Color VolumeSppm::scatteredAlong(const MediumSpan& span, int length, std::uint64_t which, const PathNumbers& numbers,
                                 RayCounts& counts) const {
    //! [scattered-along]
    const MediumDirect how = settings_.direct;
    Color sum = Color::Zero();
    if (inMedia_) {
        const BeamSettings beam = {beamRadius_, settings_.limits.maxLength, length, how == MediumDirect::Photons};
        sum = inMedia_->radiance(span, beam);
    }
    if (length >= settings_.limits.maxLength || how == MediumDirect::Photons) return sum;
    const PathNumbers own = numbers.branch(mediumBranch + which);
    const auto& direct = how == MediumDirect::Marching ? scatteredByMarching : scatteredEquiAngular;
    return sum + direct(scene(), lights_, span, settings_.places, length - 1, own, counts);
    //! [scattered-along]
}

Color VolumeSppm::atSurface(const VisiblePoint& point, const PathNumbers& numbers, RayCounts& counts) const {
    Color sum = Color::Zero();
    if (point.length < settings_.limits.maxLength) sum += directAtPoint(scene(), lights_, point, numbers, counts);
    if (!onSurfaces_) return sum;
    const Gathered found = onSurfaces_->gather(point, radius_, settings_.limits.maxLength);
    return sum + found.flux / (std::numbers::pi * radius_ * radius_);
}

}  // namespace caustic
