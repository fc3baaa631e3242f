#include "integrator/light_choice.h"

namespace caustic {

LightChoice::LightChoice(const std::vector<std::shared_ptr<const Light>>& lights) {
    std::vector<Real> powers;
    for (const auto& light : lights) {
        const Real power = light->power().maxCoeff();
        if (!(power > 0)) continue;
        powers.push_back(power);
        lights_.push_back({light.get(), 0});
    }
    if (powers.empty()) return;
    distribution_.emplace(powers);
    for (std::size_t i = 0; i < lights_.size(); ++i) {
        ChosenLight& one = lights_[i];
        one.probability = distribution_->probability(i);
        if (one.light->infinite()) infinite_.push_back(one);
        probabilities_[one.light] = one.probability;
    }
}

std::optional<ChosenLight> LightChoice::choose(Real u) const {
    if (lights_.empty()) return std::nullopt;
    if (lights_.size() == 1) return lights_.front();
    return lights_[distribution_->index(u)];
}

Real LightChoice::probability(const Light& light) const {
    const auto found = probabilities_.find(&light);
    return found != probabilities_.end() ? found->second : 0;
}

}  // namespace caustic
