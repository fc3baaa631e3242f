#include "integrator/light_choice.h"

#include <algorithm>

namespace caustic {

LightChoice::LightChoice(const std::vector<std::shared_ptr<const Light>>& lights) {
    Real all = 0;
    for (const auto& light : lights) all += light->power().maxCoeff();
    Real sum = 0;
    for (const auto& light : lights) {
        const Real power = light->power().maxCoeff();
        if (!(power > 0)) continue;
        const ChosenLight one = {light.get(), power / all};
        sum += one.probability;
        lights_.push_back(one);
        upTo_.push_back(sum);
        if (light->infinite()) infinite_.push_back(one);
        probabilities_[light.get()] = one.probability;
    }
}

std::optional<ChosenLight> LightChoice::choose(Real u) const {
    if (lights_.empty()) return std::nullopt;
    if (lights_.size() == 1) return lights_.front();
    const auto after = std::upper_bound(upTo_.begin(), upTo_.end() - 1, u);
    return lights_[static_cast<std::size_t>(after - upTo_.begin())];
}

Real LightChoice::probability(const Light& light) const {
    const auto found = probabilities_.find(&light);
    return found != probabilities_.end() ? found->second : 0;
}

}  // namespace caustic
