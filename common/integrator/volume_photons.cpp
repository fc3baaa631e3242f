#include "integrator/volume_photons.h"

#include <algorithm>

#include "core/check.h"
#include "core/parallel.h"
#include "integrator/light_start.h"
#include "integrator/walk.h"

namespace caustic {

namespace {

constexpr std::uint64_t photonStream = 2;  // as in tracePhotons
constexpr std::int64_t photonsPerBatch = 1024;

// What a batch of photons leaves behind. Batches are the same for any number of threads, and so is what they add up to.
struct Batch {
    VolumePhotons photons;
    RayCounts counts;
};

// Follows one photon.
class VolumePhotonVisitor {
public:
    VolumePhotonVisitor(Real share, Batch& batch) : share_(share), batch_(batch) {}

    bool reached(const Interaction& at, const WalkState& path) {
        //! [volume-photon]
        if (!at.isSurface()) {
            batch_.photons.inMedia.push_back(
                {at.point(), at.wo(), share_ * path.beta, Vec3::Zero(), path.length, way_});
        } else if (way_ != PhotonWay::Direct && at.connectible()) {
            batch_.photons.onSurfaces.push_back(
                {at.point(), at.wo(), share_ * path.beta, at.hit().ng, path.length, way_});
        }
        return true;
        //! [volume-photon]
    }

    void scattered(const Interaction&, const BsdfSample& sample) { way_ = scatteredWay(way_, sample.delta()); }
    void escaped(const WalkState&) {}

private:
    Real share_;
    Batch& batch_;
    PhotonWay way_ = PhotonWay::Direct;
};

}  // namespace

VolumePhotons traceVolumePhotons(const Scene& scene, const LightChoice& lights, const Sampler& sampler,
                                 const PathLimits& limits, std::int64_t first, std::int64_t count, int threads,
                                 RayCounts& counts) {
    checkLimits(limits);
    checkArgument(count >= 1, "photons", std::to_string(count), "must be at least 1");
    std::vector<Batch> batches(static_cast<std::size_t>((count + photonsPerBatch - 1) / photonsPerBatch));
    const Real share = 1 / static_cast<Real>(count);
    parallelFor(static_cast<std::int64_t>(batches.size()), threads, [&](std::int64_t item) {
        Batch& batch = batches[static_cast<std::size_t>(item)];
        const std::int64_t end = std::min(count, (item + 1) * photonsPerBatch);
        for (std::int64_t i = item * photonsPerBatch; i < end; ++i) {
            const PathNumbers numbers = sampler.start(photonStream, {0, 0}, first + i);
            const auto start = startAtLight(scene, lights, numbers);
            if (!start || (start->beta == 0).all()) continue;
            VolumePhotonVisitor visitor(share, batch);
            walk(scene, WalkState(start->emission.ray, start->media, start->beta), TransportMode::Importance, limits,
                 numbers, batch.counts, visitor);
        }
    });
    VolumePhotons all;
    for (const Batch& batch : batches) {
        const VolumePhotons& own = batch.photons;
        all.onSurfaces.insert(all.onSurfaces.end(), own.onSurfaces.begin(), own.onSurfaces.end());
        all.inMedia.insert(all.inMedia.end(), own.inMedia.begin(), own.inMedia.end());
        counts += batch.counts;
    }
    return all;
}

}  // namespace caustic
