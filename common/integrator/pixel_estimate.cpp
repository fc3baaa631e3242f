#include "integrator/pixel_estimate.h"

#include <limits>

#include "core/not_implemented.h"

namespace caustic {

void PixelEstimate::add(const Color& batch) {
    //! [ex-10.4]
    ++batches;
    const Color before = batch - mean;
    mean += before / static_cast<Real>(batches);
    // Welford 1962, eq. I.
    squares += before * (batch - mean);
    //! [ex-10.4]
}

Color PixelEstimate::variance() const {
    if (batches < 2) return Color::Constant(std::numeric_limits<Real>::infinity());
    return squares / (static_cast<Real>(batches) * static_cast<Real>(batches - 1));
}

Color PixelEstimate::halfWidth(Real deviations) const {
    //! [ex-10.5]
    if (batches < 2) return Color::Constant(std::numeric_limits<Real>::infinity());
    return studentT(deviations, batches - 1) * variance().sqrt();
    //! [ex-10.5]
}

Real studentT(Real z, std::int64_t degrees) {
    const auto n = static_cast<Real>(degrees);
    const Real z2 = z * z;
    // Abramowitz, Stegun, 26.7.5: g1 to g4.
    const Real g1 = z * (z2 + 1) / 4;
    const Real g2 = z * ((5 * z2 + 16) * z2 + 3) / 96;
    const Real g3 = z * (((3 * z2 + 19) * z2 + 17) * z2 - 15) / 384;
    const Real g4 = z * ((((79 * z2 + 776) * z2 + 1482) * z2 - 1920) * z2 - 945) / 92160;
    return z + (g1 + (g2 + (g3 + g4 / n) / n) / n) / n;
}

PixelEstimates::PixelEstimates(int width, int height)
    : width_(width), height_(height), pixels_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {}

Real PixelEstimates::brightness() const {
    Real sum = 0;
    for (const PixelEstimate& pixel : pixels_) sum += pixel.mean.mean();
    return sum / static_cast<Real>(pixels_.size());
}

}  // namespace caustic
