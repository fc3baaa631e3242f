#pragma once

#include <memory>
#include <optional>
#include <unordered_map>
#include <vector>

#include "light/light.h"
#include "sampling/discrete_distribution.h"

namespace caustic {

/// A light and how likely it was to be chosen.
struct ChosenLight {
    const Light* light = nullptr;
    Real probability = 0;  ///< 0 for one that is nothing beside the others: it is never chosen
};

/// Chooses one of a scene's lights, each in proportion to its power (its largest channel). Whoever samples one light
/// instead of all of them divides what it brings by the probability.
class LightChoice {
public:
    /// The lights are kept by reference.
    explicit LightChoice(const std::vector<std::shared_ptr<const Light>>& lights);

    /// Chooses one.
    /// @param u  uniform in [0, 1)
    /// @return nothing when no light shines
    std::optional<ChosenLight> choose(Real u) const;

    /// How likely a light is to be chosen; 0 for one that doesn't shine.
    Real probability(const Light& light) const;

    /// The lights that rays find when they leave the scene.
    const std::vector<ChosenLight>& infinite() const { return infinite_; }

private:
    std::vector<ChosenLight> lights_;                   // those that shine
    std::optional<DiscreteDistribution> distribution_;  // of lights_
    std::vector<ChosenLight> infinite_;
    std::unordered_map<const Light*, Real> probabilities_;
};

}  // namespace caustic
