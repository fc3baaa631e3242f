#include "integrator/photon_mapper.h"

#include "core/check.h"
#include "core/not_implemented.h"
#include "integrator/direct_light.h"
#include "integrator/walk.h"

namespace caustic {

namespace {

constexpr std::uint64_t gatherBranch = 8;  // the numbers of gather rays

bool spreadsLight(const Scene& scene) { return scene.needs().diffuse || scene.needs().glossy; }

const PhotonMapperSettings& checked(const PhotonMapperSettings& settings) {
    checkArgument(settings.photons >= 1, "photons", std::to_string(settings.photons), "must be at least 1");
    checkLimits(settings.limits);
    checkDensity(settings.density);
    checkDensity(settings.caustics);
    checkArgument(settings.gatherRays >= 1, "gather rays", std::to_string(settings.gatherRays), "must be at least 1");
    return settings;
}

PhotonMap mapOf(std::vector<Photon> photons, const std::function<bool(PhotonWay)>& wanted) {
    std::erase_if(photons, [&wanted](const Photon& photon) { return !wanted(photon.way); });
    return PhotonMap(photons);
}

}  // namespace

// Goes on over delta lobes, and looks where light is spread.
class PhotonMapper::EyeVisitor {
public:
    EyeVisitor(const PhotonMapper& mapper, const PathNumbers& numbers, RayCounts& counts)
        : mapper_(mapper), numbers_(numbers), counts_(counts) {}

    bool reached(const Interaction& at, const WalkState& path) {
        if (at.light() != nullptr) sum_ += path.beta * at.Le();
        if (!at.scatters() || !at.connectible()) return true;
        sum_ += path.beta * mapper_.scatteredToEye(at, path.length - 1, numbers_, counts_);
        return false;
    }

    void scattered(const Interaction&, const BsdfSample&) {}
    void escaped(const WalkState& path) { sum_ += path.beta * mapper_.scene().Le(path.ray); }

    const Color& sum() const { return sum_; }

private:
    const PhotonMapper& mapper_;
    const PathNumbers& numbers_;
    RayCounts& counts_;
    Color sum_ = Color::Zero();
};

// The same for a ray that gathers indirect light. Lamps that it meets don't count: they are direct light, or a caustic.
class PhotonMapper::GatherVisitor {
public:
    explicit GatherVisitor(const PhotonMapper& mapper) : mapper_(mapper) {}

    bool reached(const Interaction& at, const WalkState& path) {
        if (!at.scatters() || !at.connectible()) return true;
        if (at.isSurface()) sum_ += path.beta * mapper_.map_.radiance(at, mapper_.settings_.density);
        return false;
    }

    void scattered(const Interaction&, const BsdfSample&) {}
    void escaped(const WalkState&) {}

    const Color& sum() const { return sum_; }

private:
    const PhotonMapper& mapper_;
    Color sum_ = Color::Zero();
};

PhotonMapper::PhotonMapper(const Scene& scene, const Sampler& sampler, const PixelFilter& filter,
                           const PhotonMapperSettings& settings, int threads)
    : Integrator(scene, sampler, filter),
      settings_(checked(settings)),
      lights_(scene.lights()),
      map_({}),
      caustics_({}) {
    if (!whyNoPhotons().empty()) return;
    const MapUse use = settings.use;
    const PhotonSettings ways = {settings.limits, settings.splits, use != MapUse::Indirect};
    std::vector<Photon> photons =
        tracePhotons(scene, lights_, sampler, ways, 0, settings.photons, threads, photonCounts_);
    if (use != MapUse::Everything && scene.needs().specular)
        caustics_ = mapOf(photons, [](PhotonWay way) { return way == PhotonWay::Caustic; });
    map_ = mapOf(std::move(photons),
                 [use](PhotonWay way) { return use != MapUse::Indirect || way == PhotonWay::Indirect; });
}

std::string PhotonMapper::whyNoPhotons() const {
    if (!lights_.choose(0)) return "no light shines, so there are no photons";
    if (!spreadsLight(scene())) return "no surface spreads light, so photons have nowhere to stay";
    return "";
}

Color PhotonMapper::Li(const Ray& ray, const MediumStack& media, const PathNumbers& numbers, RayCounts& counts) const {
    EyeVisitor visitor(*this, numbers, counts);
    walk(scene(), WalkState(ray, media, Color::Ones()), TransportMode::Radiance, settings_.limits, numbers, counts,
         visitor);
    return visitor.sum();
}

Color PhotonMapper::scatteredToEye(const Interaction& at, int vertex, const PathNumbers& numbers,
                                   RayCounts& counts) const {
    //! [ex-08.8]
    Color sum = Color::Zero();
    if (settings_.use != MapUse::Everything) {
        const auto direct = sampleDirectLight(scene(), lights_, at, vertex, numbers, counts);
        if (direct) sum += direct->value;
    }
    if (!at.isSurface()) return sum;
    if (caustics_.size() > 0) sum += caustics_.radiance(at, settings_.caustics);
    if (map_.size() == 0) return sum;
    return sum + (settings_.use == MapUse::Gather ? gather(at, vertex, numbers, counts)
                                                  : map_.radiance(at, settings_.density));
    //! [ex-08.8]
}

Color PhotonMapper::gather(const Interaction& at, int vertex, const PathNumbers& numbers, RayCounts& counts) const {
    //! [final-gather]
    GatherVisitor visitor(*this);
    const int rays = settings_.gatherRays;
    for (int i = 0; i < rays; ++i) {
        const PathNumbers own = numbers.branch(gatherBranch).part(i, rays);
        const auto next = scatter(at, TransportMode::Radiance, own, vertex);
        if (!next || (next->weight == 0).all()) continue;
        WalkState ray(at.spawn(next->sample.wi), at.media(next->sample.wi), next->weight / rays);
        ray.length = vertex + 1;
        walk(scene(), ray, TransportMode::Radiance, settings_.limits, own, counts, visitor);
    }
    return visitor.sum();
    //! [final-gather]
}

}  // namespace caustic
