#include "integrator/adaptive_rule.h"

#include <algorithm>
#include <array>

#include "core/check.h"
#include "core/not_implemented.h"
#include "core/parallel.h"
#include "image/laplacian.h"
#include "integrator/path_hash.h"

namespace caustic {

HashRule::HashRule(const Scene& scene, int maxLength, int threads, RayCounts& counts) {
    const Camera& camera = scene.camera();
    const auto columns = static_cast<std::size_t>(camera.width()) + 1;
    const auto rows = static_cast<std::size_t>(camera.height()) + 1;
    std::vector<std::uint64_t> hashes(columns * rows);
    std::vector<RayCounts> own(rows);
    parallelFor(static_cast<std::int64_t>(rows), threads, [&](std::int64_t item) {
        const auto y = static_cast<std::size_t>(item);
        for (std::size_t x = 0; x < columns; ++x) {
            const Ray ray = camera.sampleRay({static_cast<Real>(x), static_cast<Real>(y)}, {0.5, 0.5});
            hashes[y * columns + x] = pathHash(scene, ray, maxLength, own[y]);
        }
    });
    for (const RayCounts& one : own) counts += one;
    for (std::size_t y = 0; y + 1 < rows; ++y) {
        for (std::size_t x = 0; x + 1 < columns; ++x) {
            const std::size_t at = y * columns + x;
            const std::array corners = {hashes[at + 1], hashes[at + columns], hashes[at + columns + 1]};
            mixed_.push_back(std::ranges::any_of(corners, [&](std::uint64_t one) { return one != hashes[at]; }));
        }
    }
}

std::vector<Real> HashRule::wanted(const PixelEstimates& soFar) const {
    std::vector<Real> wanted(soFar.size(), 0);
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        if (mixed_[i]) wanted[i] = 1 / static_cast<Real>(soFar[i].batches);
    }
    return wanted;
}

EdgeRule::EdgeRule(Real threshold) : threshold_(threshold) {
    checkPositive(threshold, "edge rule's threshold");
    checkArgument(threshold <= 4, "edge rule's threshold", formatReal(threshold), "must be at most 4");
}

std::vector<Real> EdgeRule::wanted(const PixelEstimates& soFar) const {
    //! [ex-10.6]
    const Real middle = soFar.brightness();
    std::vector<Real> wanted(soFar.size(), 0);
    if (middle <= 0) return wanted;
    Image shown(soFar.width(), soFar.height());
    const auto at = [&](std::size_t i) {
        return std::pair(static_cast<int>(i) % soFar.width(), static_cast<int>(i) / soFar.width());
    };
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        const auto [x, y] = at(i);
        shown.set(x, y, soFar[i].mean / (soFar[i].mean + middle));
    }
    const Image edges = laplacian(shown);
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        const auto [x, y] = at(i);
        const Real edge = edges.at(x, y).abs().maxCoeff();
        // Edges stay as paths come: those with few paths come first.
        if (edge > threshold_) wanted[i] = edge / static_cast<Real>(soFar[i].batches);
    }
    return wanted;
    //! [ex-10.6]
}

IntervalRule::IntervalRule(Real tolerance, Real deviations) : tolerance_(tolerance), deviations_(deviations) {
    checkPositive(tolerance, "interval rule's tolerance");
    checkPositive(deviations, "interval rule's deviations");
}

std::vector<Real> IntervalRule::wanted(const PixelEstimates& soFar) const {
    const Real middle = soFar.brightness();
    std::vector<Real> wanted(soFar.size(), 0);
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        const Color allowed = tolerance_ * (soFar[i].mean + middle);
        const Color width = soFar[i].halfWidth(deviations_);
        if ((width > allowed).any()) wanted[i] = (width / allowed).maxCoeff();
    }
    return wanted;
}

std::vector<Real> GainRule::wanted(const PixelEstimates& soFar) const {
    std::vector<Real> wanted(soFar.size(), 0);
    for (std::size_t i = 0; i < wanted.size(); ++i)
        wanted[i] = soFar[i].variance().sum() / static_cast<Real>(soFar[i].batches + 1);
    return wanted;
}

}  // namespace caustic
