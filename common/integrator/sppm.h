#pragma once

#include <optional>
#include <string>
#include <vector>

#include "integrator/integrator.h"
#include "integrator/light_choice.h"
#include "integrator/path_limits.h"
#include "integrator/photon_grid.h"
#include "integrator/radius_rule.h"
#include "integrator/visible_point.h"

namespace caustic {

/// Settings of Sppm.
struct SppmSettings {
    PathLimits limits = {};              ///< segments from the eye and from the light to where they meet, together
    RadiusRule rule = RadiusRule::Pass;  ///< how the radius gets smaller
    Real alpha = 2.0 / 3;                ///< of either rule, in (0, 1)
    Real radius = 0;                     ///< of the first pass, m; 0 for usualRadius of the scene
    int photons = 1 << 16;               ///< that set out in each pass, at least 1
};

/// The radius of the first pass that does well in many scenes: 2.3 % of the radius of a ball around the scene, m; 0.023
/// when nothing in it is bounded.
Real usualRadius(const Scene& scene);

/// Stochastic progressive photon mapping: pass by pass new photons from the lights and new points from the eye, with a
/// radius that shrinks from pass to pass. What a point gets straight from the lamps is sampled there; photons carry the
/// light that comes over other surfaces. So caustics converge that are seen through glass or in a mirror, which no
/// method that connects paths finds. Points at which a medium scatters get no photons.
///
/// By rule Pass, passes depend on nothing but their number. Rule Point keeps statistics of each pixel, whose photons
/// develop() adds to the picture.
/// Source: Hachisuka, Jensen 2009, Stochastic Progressive Photon Mapping, ACM TOG 28(5); Knaus, Zwicker 2011.
class Sppm final : public Integrator {
public:
    /// @throws InputError when a setting is out of its range
    Sppm(const Scene& scene, const Sampler& sampler, const PixelFilter& filter, const SppmSettings& settings);

    /// @throws InputError when rule Point gets a pixel twice in a pass, which it would shrink twice for the same
    /// photons
    Rendering runPass(const Pass& pass, int threads) override;
    void develop(Image& picture) const override;
    void save(ByteWriter& to) const override;
    void load(ByteReader& from) override;

    /// By the photons of the last pass, within the radius of rule Pass; without indirect light before the first one.
    Color Li(const Ray& ray, const MediumStack& media, const PathNumbers& numbers, RayCounts& counts) const override;

    /// Settings as they are used: the radius is that of the first pass.
    const SppmSettings& settings() const { return settings_; }
    /// What rule Point keeps of a pixel.
    const PointStatistics& statistics(Pixel pixel) const { return pixels_[offset(pixel)].statistics; }
    /// Why there are no photons, in a sentence for a warning; empty when there are some.
    std::string whyNoPhotons() const;
    /// Photons that the last pass left on surfaces.
    std::size_t storedPhotons() const { return photons_ ? photons_->size() : 0; }

private:
    struct PixelState {
        PointStatistics statistics;
        std::int64_t passes = 0;  // in which it had a path
    };
    // What a path from the eye brings.
    struct Found {
        Color direct = Color::Zero();  // all but photons, W/(m²·sr)
        Gathered photons;
    };

    std::size_t offset(Pixel pixel) const;
    void traceNewPhotons(std::int64_t pass, int threads, RayCounts& counts);
    Found look(const Ray& ray, const MediumStack& media, const PathNumbers& numbers, Real radius,
               RayCounts& counts) const;
    Found look(const PathId& path, RayCounts& counts) const;
    void updateStatistics(const Pass& pass, const std::vector<Found>& found);

    SppmSettings settings_;
    LightChoice lights_;
    Real radius_;                        // of this pass, by rule Pass; what most pixels have by rule Point
    std::optional<PhotonGrid> photons_;  // of this pass; none when there is nothing to light, or nothing that does
    std::vector<PixelState> pixels_;     // row by row; empty by rule Pass
};

}  // namespace caustic
