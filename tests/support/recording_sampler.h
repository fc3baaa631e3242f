#pragma once

#include <set>
#include <tuple>
#include <vector>

#include "core/random.h"
#include "sampling/sampler.h"

namespace caustic::test {

/// Independent numbers, and a list of which were asked for: by one thread only.
class RecordingSampler final : public Sampler {
public:
    /// A number of a path that was asked for.
    struct Asked {
        std::uint64_t stream = 0;
        std::int64_t index = 0;
        int dimension = 0;

        /// By all three.
        bool operator<(const Asked& other) const {
            return std::tie(stream, index, dimension) < std::tie(other.stream, other.index, other.dimension);
        }
    };

    Real number(const PathName& path, Dimension dimension) const override {
        asked_.push_back({path.stream, path.index, dimension.index});
        return uniform(path, dimension.index);
    }

    Vec2 pair(const PathName& path, Dimension dimension) const override {
        asked_.push_back({path.stream, path.index, dimension.index});
        return {uniform(path, dimension.index), uniform(path, dimension.index + 1)};
    }

    /// All that was asked for since the last `forget`; a pair once.
    const std::vector<Asked>& asked() const { return asked_; }

    /// How many different ones these are.
    std::size_t different() const { return std::set<Asked>(asked_.begin(), asked_.end()).size(); }

    /// Begins a new list.
    void forget() const { asked_.clear(); }

private:
    static Real uniform(const PathName& path, int dimension) {
        return Random(77, {path.stream, static_cast<std::uint64_t>(path.index), static_cast<std::uint64_t>(dimension)})
            .uniform();
    }

    mutable std::vector<Asked> asked_;
};

}  // namespace caustic::test
