#include "integrator/path_hash.h"

#include "core/mixer.h"
#include "core/not_implemented.h"

namespace caustic {

namespace {

// A number made of what was before and of what comes next: another order is another number.
std::uint64_t hashed(std::uint64_t before, std::uint64_t next) { return splitMix(before + (next + 1) * goldenStep); }

}  // namespace

std::uint64_t pathHash(const Scene& scene, const Ray& ray, int maxLength, RayCounts& counts) {
    //! [ex-10.3]
    Ray next = ray;
    MediumStack media = scene.cameraMedia();
    std::uint64_t hash = 0;
    for (int length = 1;; ++length) {
        Color passed;
        const auto at = scene.follow(next, media, passed, counts);
        if (!at) return hashed(hash, 0);
        const bool outside = at->wo().dot(at->hit().ng) >= 0;
        hash = hashed(hash, 2 * static_cast<std::uint64_t>(at->hit().object + 1) + (outside ? 1 : 0));
        if (!at->scatters() || at->connectible() || length >= maxLength) return hash;
        // No random numbers: of two lobes it is the likelier one, or neighbours would differ by chance.
        const BsdfSample* likeliest = nullptr;
        const DeltaLobes lobes = at->bsdf()->deltaLobes(at->wo(), TransportMode::Radiance);
        for (const BsdfSample& lobe : lobes) {
            if (likeliest == nullptr || lobe.pdfW > likeliest->pdfW) likeliest = &lobe;
        }
        if (likeliest == nullptr) return hash;
        hash = hashed(hash, likeliest->transmits() ? 1 : 0);
        media = at->media(likeliest->wi);
        next = at->spawn(likeliest->wi);
    }
    //! [ex-10.3]
}

}  // namespace caustic
