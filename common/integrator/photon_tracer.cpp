#include "integrator/photon_tracer.h"

#include <algorithm>

#include "core/check.h"
#include "core/not_implemented.h"
#include "core/parallel.h"
#include "integrator/light_start.h"
#include "integrator/walk.h"

namespace caustic {

namespace {

constexpr std::uint64_t photonStream = 2;  // paths from the eye and from lights have 0 and 1
constexpr std::int64_t photonsPerBatch = 1024;

// What a batch of photons leaves behind. Batches are the same for any number of threads, and so is what they add up to.
struct Batch {
    std::vector<Photon> photons;
    RayCounts counts;
};

// Follows one photon.
class PhotonVisitor {
public:
    // share: what part of a lamp's light one of all photons stands for.
    PhotonVisitor(const Scene& scene, const PhotonSettings& settings, Real share, const PathNumbers& numbers,
                  Batch& batch)
        : scene_(scene), settings_(settings), share_(share), numbers_(numbers), batch_(batch) {}

    bool reached(const Interaction& at, const WalkState& path) {
        //! [ex-08.2]
        const bool wanted = way_ != PhotonWay::Direct || settings_.direct;
        if (wanted && at.isSurface() && at.connectible())
            batch_.photons.push_back({at.point(), at.wo(), share_ * path.beta, at.hit().ng, path.length, way_});
        if (path.length > settings_.splits || at.bsdf() == nullptr) return true;
        split(at, path);
        return false;
        //! [ex-08.2]
    }

    void scattered(const Interaction&, const BsdfSample& sample) { way_ = scatteredWay(way_, sample.delta()); }
    void escaped(const WalkState&) {}

private:
    // On by every lobe at once: each delta lobe, and one direction for all that spread light.
    void split(const Interaction& at, const WalkState& path) {
        //! [ex-08.3]
        if (path.length >= settings_.limits.maxLength) return;
        std::uint64_t part = 0;
        for (const BsdfSample& lobe : at.bsdf()->deltaLobes(at.wo(), TransportMode::Importance))
            sendOn(at, path, lobe, lobe.f, numbers_.branch(part++));
        if (!at.connectible()) return;
        const PathNumbers numbers = numbers_.branch(part);
        const auto next = scatter(at, TransportMode::Importance, numbers, path.length - 1);
        if (next && !next->sample.delta()) sendOn(at, path, next->sample, next->weight, numbers);
        //! [ex-08.3]
    }

    // A part of the photon sets out from a vertex with a share of its power and numbers of its own.
    void sendOn(const Interaction& at, const WalkState& path, const BsdfSample& sample, const Color& weight,
                const PathNumbers& numbers) {
        const Color beta = path.beta * weight;
        if ((beta == 0).all()) return;
        WalkState part(at.spawn(sample.wi), at.media(sample.wi), beta);
        part.length = path.length;
        PhotonVisitor visitor(scene_, settings_, share_, numbers, batch_);
        visitor.way_ = scatteredWay(way_, sample.delta());
        walk(scene_, part, TransportMode::Importance, settings_.limits, numbers, batch_.counts, visitor);
    }

    const Scene& scene_;
    const PhotonSettings& settings_;
    Real share_;
    PathNumbers numbers_;
    Batch& batch_;
    PhotonWay way_ = PhotonWay::Direct;
};

// One photon, from its lamp to its end.
void tracePhoton(const Scene& scene, const LightChoice& lights, const PhotonSettings& settings, Real share,
                 const PathNumbers& numbers, Batch& batch) {
    //! [trace-photon]
    const auto start = startAtLight(scene, lights, numbers);
    if (!start || (start->beta == 0).all()) return;
    PhotonVisitor visitor(scene, settings, share, numbers, batch);
    walk(scene, WalkState(start->emission.ray, start->media, start->beta), TransportMode::Importance, settings.limits,
         numbers, batch.counts, visitor);
    //! [trace-photon]
}

}  // namespace

std::vector<Photon> tracePhotons(const Scene& scene, const LightChoice& lights, const Sampler& sampler,
                                 const PhotonSettings& settings, std::int64_t first, std::int64_t count, int threads,
                                 RayCounts& counts) {
    checkLimits(settings.limits);
    checkArgument(settings.splits >= 0 && settings.splits <= 16, "splits of a photon", std::to_string(settings.splits),
                  "must be from 0 to 16");
    checkArgument(count >= 1, "photons", std::to_string(count), "must be at least 1");
    //! [ex-08.4]
    std::vector<Batch> batches(static_cast<std::size_t>((count + photonsPerBatch - 1) / photonsPerBatch));
    const Real share = 1 / static_cast<Real>(count);
    parallelFor(static_cast<std::int64_t>(batches.size()), threads, [&](std::int64_t item) {
        const std::int64_t end = std::min(count, (item + 1) * photonsPerBatch);
        for (std::int64_t i = item * photonsPerBatch; i < end; ++i) {
            const PathNumbers numbers = sampler.start(photonStream, {0, 0}, first + i);
            tracePhoton(scene, lights, settings, share, numbers, batches[static_cast<std::size_t>(item)]);
        }
    });
    std::vector<Photon> photons;
    for (const Batch& batch : batches) {
        photons.insert(photons.end(), batch.photons.begin(), batch.photons.end());
        counts += batch.counts;
    }
    return photons;
    //! [ex-08.4]
}

}  // namespace caustic
