#include "sampling/stratified_sampler.h"

#include <algorithm>

#include "core/check.h"
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
    const Real jitter = PathStream(seed_, path, path.index).number(dimension);
    return placed(cellOf(path, dimension), jitter, perAxis_ * perAxis_);
}

Vec2 StratifiedSampler::pair(const PathName& path, Dimension dimension) const {
    const Vec2 jitter = PathStream(seed_, path, path.index).pair(dimension);
    const std::uint32_t cell = cellOf(path, dimension);
    return {placed(cell % perAxis_, jitter.x(), perAxis_), placed(cell / perAxis_, jitter.y(), perAxis_)};
}

std::uint32_t StratifiedSampler::cellOf(const PathName& path, Dimension dimension) const {
    const std::int64_t cells = std::int64_t{perAxis_} * perAxis_;
    const PathStream shuffle(seed_ ^ shuffling, path, path.index / cells);
    const auto key = static_cast<std::uint32_t>(shuffle.bits(dimension) >> 32);
    return permuted(static_cast<std::uint32_t>(path.index % cells), static_cast<std::uint32_t>(cells), key);
}

}  // namespace caustic
