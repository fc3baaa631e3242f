#include "sampling/sampler.h"

#include "core/mixer.h"

namespace caustic {

Real PathNumbers::number(Dimension dimension) const { return sampler_->number(name_, dimension); }

Vec2 PathNumbers::pair(Dimension dimension) const { return sampler_->pair(name_, dimension); }

PathNumbers PathNumbers::branch(std::uint64_t label) const {
    PathName name = name_;
    // An odd multiplier makes the map of streams one to one for each label; the finaliser of the sampler does the rest.
    name.stream = name.stream * goldenStep + label + 1;
    return {*sampler_, name};
}

PathNumbers PathNumbers::part(int i, int n) const {
    PathName name = name_;
    name.index = name.index * n + i;
    return {*sampler_, name};
}

}  // namespace caustic
