#include "sampling/stratified_sampler.h"

#include <algorithm>

#include "core/check.h"
#include "core/random.h"
#include "sampling/path_stream.h"
#include "sampling/permutation.h"

namespace caustic {

namespace {

constexpr Real belowOne = 1 - 0x1p-53;

// The streams that shuffle cells must not be those that place points in them.
constexpr std::uint64_t shuffling = 0x5eed0f5eed0f5eedULL;

// (cell + jitter) / cells, kept below 1: the sum may round up.
Real placed(std::uint32_t cell, Real jitter, std::uint32_t cells) {
    return std::min((cell + jitter) / cells, belowOne);
}

}  // namespace

StratifiedSampler::StratifiedSampler(std::uint64_t seed, int perAxis)
    : seed_(seed), perAxis_(static_cast<std::uint32_t>(perAxis)) {
    checkArgument(perAxis >= 1 && perAxis <= 4096, "stratified sampler's cells per axis", std::to_string(perAxis),
                  "must be 1 to 4096");
}

Real StratifiedSampler::number(const PathName& path, Dimension dimension) const {
    Random random = pathStream(seed_, path, dimension, path.index);
    return placed(cellOf(path, dimension), random.uniform(), perAxis_ * perAxis_);
}

Vec2 StratifiedSampler::pair(const PathName& path, Dimension dimension) const {
    Random random = pathStream(seed_, path, dimension, path.index);
    const std::uint32_t cell = cellOf(path, dimension);
    const Real first = placed(cell % perAxis_, random.uniform(), perAxis_);
    return {first, placed(cell / perAxis_, random.uniform(), perAxis_)};
}

std::uint32_t StratifiedSampler::cellOf(const PathName& path, Dimension dimension) const {
    const std::int64_t cells = std::int64_t{perAxis_} * perAxis_;
    Random shuffle = pathStream(seed_ ^ shuffling, path, dimension, path.index / cells);
    const std::uint32_t key = static_cast<std::uint32_t>(shuffle.below(std::uint64_t{1} << 32));
    return permuted(static_cast<std::uint32_t>(path.index % cells), static_cast<std::uint32_t>(cells), key);
}

}  // namespace caustic
