#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "integrator/integrator.h"
#include "integrator/light_choice.h"
#include "integrator/photon_map.h"
#include "integrator/photon_tracer.h"

namespace caustic {

/// What photons are used for.
enum class MapUse {
    Everything,  ///< all light is looked up in one map: the report's way
    Indirect,  ///< direct light is sampled; caustics and other indirect light are looked up in a map of their own each
    Gather     ///< direct light is sampled, caustics are looked up, and other indirect light is gathered by rays, at
               ///< whose ends all light is looked up
};

/// Settings of a PhotonMapper.
struct PhotonMapperSettings {
    std::int64_t photons = 100'000;  ///< that set out; at least 1
    PathLimits limits = {16, 1};     ///< of a photon's way, and of a path from the eye
    int splits = 0;                  ///< vertices at which a photon is split instead of choosing a lobe
    MapUse use = MapUse::Indirect;   ///< what photons are used for
    DensitySettings density = {};    ///< of the map for all light, or for indirect light
    DensitySettings caustics = {};   ///< of the map for caustics
    int gatherRays = 16;             ///< of each path, for MapUse::Gather; at least 1
};

/// Photon mapping: photons are sent out from the lamps once and stay where they arrive; then paths from the eye go on
/// over mirrors and through smooth glass to the first non-specular surface, and look there. So light is found
/// that comes over delta lobes to a surface which is seen over delta lobes. The price is blur: of what the photons of a
/// disc bring, all points around its middle get the mean. Points at which a medium scatters get direct light only.
///
/// A map for caustics is made only where the scene has specular surfaces, and photons are sent out only where something
/// shines and something is non-specular.
/// Source: Jensen 1996, Global Illumination using Photon Maps; Jensen 2001.
class PhotonMapper final : public Integrator {
public:
    /// Makes the maps.
    /// @param threads  at least 1; nothing depends on it but the time
    /// @throws InputError when a setting is out of its range
    PhotonMapper(const Scene& scene, const Sampler& sampler, const PixelFilter& filter,
                 const PhotonMapperSettings& settings, int threads);

    Color Li(const Ray& ray, const MediumStack& media, const PathNumbers& numbers, RayCounts& counts) const override;

    /// Photons of the map for all light, or for indirect light.
    const PhotonMap& map() const { return map_; }
    /// Those of the map for caustics; none in it when there is no such map.
    const PhotonMap& caustics() const { return caustics_; }
    /// What photons asked of the scene.
    const RayCounts& photonCounts() const { return photonCounts_; }

    /// Why there are no photons, in a sentence for a warning; empty when there are some.
    std::string whyNoPhotons() const;

private:
    class EyeVisitor;
    class GatherVisitor;

    Color scatteredToEye(const Interaction& at, int vertex, const PathNumbers& numbers, RayCounts& counts) const;
    Color gather(const Interaction& at, int vertex, const PathNumbers& numbers, RayCounts& counts) const;

    PhotonMapperSettings settings_;
    LightChoice lights_;
    RayCounts photonCounts_;
    PhotonMap map_;
    PhotonMap caustics_;
};

}  // namespace caustic
