#include "sampling/sobol_sampler.h"

#include "sampling/path_stream.h"
#include "sampling/sobol.h"

namespace caustic {

namespace {

// The stream that scrambles must not be the one that plain numbers come from.
constexpr std::uint64_t scrambling = 0x0e50b010e50b01ULL;

// Where a number comes from.
struct Source {
    int first = -1;         // dimension of Sobol's sequence; -1 for a random number
    bool shuffled = false;  // whether in an order of its own
};

Source sourceOf(Dimension dimension) {
    const auto isFirst = [dimension](VertexUse use) { return dimension.index == Dimension::vertex(0, use).index; };
    if (dimension.index >= 0 && dimension.index < 4) return {dimension.index, false};
    if (isFirst(VertexUse::Direction)) return {4, false};
    if (isFirst(VertexUse::LightPoint) || isFirst(VertexUse::LightChoice) || isFirst(VertexUse::Lobe)) return {0, true};
    return {};
}

Real fraction(std::uint32_t bits) { return bits * 0x1p-32; }

// One pixel's points of one stream, scrambled. Beyond 2^32 points a new scrambling begins.
class Points {
public:
    Points(std::uint64_t seed, const PathName& path, Dimension dimension, const Source& source)
        : stream_(seed ^ scrambling, path, path.index >> 32),
          dimension_(dimension.index),
          first_(source.first),
          index_(static_cast<std::uint32_t>(path.index)) {
        // Source: Burley 2020, section 4: the index, scrambled likewise, is a shuffle that keeps runs of 2^m together.
        if (source.shuffled) index_ = owenScrambled(index_, static_cast<std::uint32_t>(stream_.bits(dimension)));
    }

    Real number(int i) const {
        const auto key = static_cast<std::uint32_t>(stream_.bits({dimension_ + i}) >> 32);
        return fraction(owenScrambled(sobolBits(index_, first_ + i), key));
    }

private:
    PathStream stream_;
    int dimension_;
    int first_;
    std::uint32_t index_;
};

}  // namespace

Real SobolSampler::number(const PathName& path, Dimension dimension) const {
    const Source source = sourceOf(dimension);
    if (source.first < 0) return PathStream(seed_, path, path.index).number(dimension);
    return Points(seed_, path, dimension, source).number(0);
}

Vec2 SobolSampler::pair(const PathName& path, Dimension dimension) const {
    const Source source = sourceOf(dimension);
    if (source.first < 0) return PathStream(seed_, path, path.index).pair(dimension);
    const Points points(seed_, path, dimension, source);
    return {points.number(0), points.number(1)};
}

}  // namespace caustic
