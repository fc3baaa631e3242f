#pragma once

#include "integrator/adaptive_rule.h"
#include "integrator/render.h"

namespace caustic {

/// How an AdaptiveIntegrator spends paths.
struct AdaptiveSettings {
    int batch = 4;   ///< paths of a pixel in a pass, at least 1
    int first = 16;  ///< paths that every pixel gets in any case, at least 1; rounded up to whole batches

    /// Of one pixel at most, at least `first`.
    std::int64_t most = std::int64_t{1} << 40;

    /// In all at most, at least 1. The last pass is cut to fit.
    std::int64_t paths = std::int64_t{1} << 60;

    Real share = 0.1;  ///< of the pixels in a pass at most, those that want it most; in (0, 1]

    /// A pixel wants as much as any that is at most so many columns and rows away, at least 0. So whatever is found at
    /// one pixel is looked for around it, too: nothing thin is lost between two of them.
    int spread = 1;

    /// Whether pixels' values decide how many paths they get, which makes a picture too dark: a pixel that has met no
    /// bright path yet looks finished. When true, every other pass only decides and is left out of the picture. Then
    /// what counts doesn't depend on its own values, and the mean is right, at half the paths.
    /// Source: Kirk, Arvo 1991, Unbiased Sampling Techniques for Image Synthesis.
    bool apart = false;
};

/// Adaptive supersampling by any method and any rule: renders as the method does, watches what each batch of a pixel's
/// paths brings, and says which pixels the next pass takes. For methods that bring the whole value of a pixel with its
/// paths: no splats, and of Sppm rule Pass.
///
/// What it watches is kept from pass to pass; checkpoints hold it.
class AdaptiveIntegrator final : public Integrator {
public:
    /// @param inner    the method; kept by reference, as the others are
    /// @param sampler  the method's
    /// @throws InputError when a setting is out of its range
    AdaptiveIntegrator(Integrator& inner, const Sampler& sampler, const AdaptiveRule& rule,
                       const AdaptiveSettings& settings);

    /// The paths of the next pass, a batch of each pixel that is chosen; none when no pixel wants any.
    std::vector<PathId> next() const;

    Rendering runPass(const Pass& pass, int threads) override;
    Color Li(const Ray& ray, const MediumStack& media, const PathNumbers& numbers, RayCounts& counts) const override;
    void develop(Image& picture) const override { inner_->develop(picture); }
    void save(ByteWriter& to) const override;
    void load(ByteReader& from) override;

    /// What is known of the pixels.
    const PixelEstimates& estimates() const { return estimates_; }
    /// How many paths a pixel has had, those that only decide included.
    std::int64_t paths(Pixel pixel) const { return given_[offset(pixel)]; }
    /// The same of all pixels together.
    std::int64_t paths() const;

private:
    std::size_t offset(Pixel pixel) const {
        return static_cast<std::size_t>(pixel.y) * static_cast<std::size_t>(estimates_.width()) +
               static_cast<std::size_t>(pixel.x);
    }
    std::vector<Real> spreadOut(const std::vector<Real>& wanted) const;

    Integrator* inner_;
    const AdaptiveRule* rule_;
    AdaptiveSettings settings_;
    PixelEstimates estimates_;
    std::vector<std::int64_t> given_;  // paths of each pixel
};

/// Renders pass by pass, pixels chosen by the integrator. Ends at a limit of the settings, of either kind, or when no
/// pixel wants any more.
/// @param settings  without a `choose` of its own
/// @throws InputError as render does
Rendering renderAdaptively(AdaptiveIntegrator& integrator, RenderSettings settings);

}  // namespace caustic
