#include "sampling/halton_sampler.h"

#include "sampling/halton.h"
#include "sampling/path_stream.h"

namespace caustic {

namespace {

// The stream that names permutations must not be the one that plain numbers come from.
constexpr std::uint64_t permuting = 0x4a170e0f4a170e0fULL;

// Which of Halton's dimensions a number comes from; -1 for a random one.
int sourceOf(Dimension dimension) {
    const auto isFirst = [dimension](VertexUse use) { return dimension.index == Dimension::vertex(0, use).index; };
    if (dimension.index >= 0 && dimension.index < 4) return dimension.index;
    if (isFirst(VertexUse::LightPoint)) return 4;
    if (isFirst(VertexUse::Direction)) return 6;
    if (isFirst(VertexUse::LightChoice)) return 8;
    if (isFirst(VertexUse::Lobe)) return 9;
    return -1;
}

// Beyond 2^32 points new permutations begin.
Real numberFrom(int source, std::uint64_t seed, const PathName& path) {
    const PathStream keys(seed ^ permuting, path, path.index >> 32);
    return haltonNumber(static_cast<std::uint32_t>(path.index), source, keys.bits({source}));
}

}  // namespace

Real HaltonSampler::number(const PathName& path, Dimension dimension) const {
    const int source = sourceOf(dimension);
    if (source < 0) return PathStream(seed_, path, path.index).number(dimension);
    return numberFrom(source, seed_, path);
}

Vec2 HaltonSampler::pair(const PathName& path, Dimension dimension) const {
    const int source = sourceOf(dimension);
    if (source < 0) return PathStream(seed_, path, path.index).pair(dimension);
    return {numberFrom(source, seed_, path), numberFrom(source + 1, seed_, path)};
}

}  // namespace caustic
