#include "sampling/sampler_names.h"

#include <cmath>

#include "core/check.h"
#include "sampling/halton_sampler.h"
#include "sampling/independent_sampler.h"
#include "sampling/sobol_sampler.h"
#include "sampling/stratified_sampler.h"

namespace caustic {

const std::vector<std::string>& samplerNames() {
    static const std::vector<std::string> names = {"random", "stratified", "halton", "sobol"};
    return names;
}

std::unique_ptr<const Sampler> makeSampler(const std::string& name, std::uint64_t seed, std::int64_t paths) {
    checkArgument(paths >= 1 && paths <= 4096 * 4096, "paths of a pixel", std::to_string(paths),
                  "must be 1 to 16777216");
    if (name == "random") return std::make_unique<IndependentSampler>(seed);
    if (name == "stratified")
        return std::make_unique<StratifiedSampler>(seed, static_cast<int>(std::ceil(std::sqrt(paths))));
    if (name == "halton") return std::make_unique<HaltonSampler>(seed);
    checkArgument(name == "sobol", "sampler", name, "must be random, stratified, halton or sobol");
    return std::make_unique<SobolSampler>(seed);
}

}  // namespace caustic
