#include "sampling/emission_sampler.h"

#include <algorithm>

#include "core/check.h"
#include "core/mixer.h"
#include "core/not_implemented.h"
#include "sampling/path_stream.h"
#include "sampling/permutation.h"

namespace caustic {

namespace {

// The streams that shuffle cells, and those that order offsets, must not be those that place points.
constexpr std::uint64_t shuffling = 0x9407059407051eedULL;
constexpr std::uint64_t offsetting = 0x0ff5e70ff5e71eedULL;

constexpr std::int64_t mostCells = std::int64_t{1} << 31;
constexpr Real belowOne = 1 - 0x1p-53;

// A key for each line of the grid: no two lines, and no row and column, have the same order.
std::uint32_t keyOfLine(std::uint64_t bits, std::uint32_t line) {
    return static_cast<std::uint32_t>(splitMix(bits + line * goldenStep) >> 32);
}

}  // namespace

EmissionSampler::EmissionSampler(std::uint64_t seed, std::int64_t columns, std::int64_t rows, CellPlace place)
    : seed_(seed),
      columns_(static_cast<std::uint32_t>(columns)),
      rows_(static_cast<std::uint32_t>(rows)),
      place_(place) {
    const auto check = [](std::int64_t lines, const std::string& what) {
        checkArgument(lines >= 1 && lines <= mostCells, what, std::to_string(lines), "must be 1 to 2147483648");
    };
    check(columns, "emission sampler's columns");
    check(rows, "emission sampler's rows");
    checkArgument(columns <= mostCells / rows, "emission sampler's cells",
                  std::to_string(columns) + " x " + std::to_string(rows), "must be at most 2147483648");
}

Real EmissionSampler::number(const PathName& path, Dimension dimension) const {
    return PathStream(seed_, path, path.index).number(dimension);
}

Vec2 EmissionSampler::pair(const PathName& path, Dimension dimension) const {
    const bool place = dimension.index == Dimension::emissionPoint().index;
    const bool direction = dimension.index == Dimension::emissionDirection().index;
    if (!place && !direction) return PathStream(seed_, path, path.index).pair(dimension);
    const std::int64_t cells = std::int64_t{columns_} * rows_;
    const auto key = PathStream(seed_ ^ shuffling, path, round(path)).bits(dimension) >> 32;
    return pointOf(permuted(static_cast<std::uint32_t>(path.index % cells), static_cast<std::uint32_t>(cells),
                            static_cast<std::uint32_t>(key)),
                   path, dimension);
}

Vec2 EmissionSampler::pointOf(std::uint32_t cell, const PathName& path, Dimension dimension) const {
    //! [ex-10.2]
    const std::uint32_t column = cell % columns_;
    const std::uint32_t row = cell / columns_;
    Vec2 within(0.5, 0.5);
    if (place_ != CellPlace::Centre) within = PathStream(seed_, path, path.index).pair(dimension);
    if (place_ == CellPlace::Offset) {
        // Chiu, Shirley, Wang 1994: a column's points take the places 0, 1/rows, 2/rows ... across it, in an order of
        // its own; a row's do the same along the other axis.
        const PathStream keys(seed_ ^ offsetting, path, round(path));
        const std::uint32_t inColumn = permuted(row, rows_, keyOfLine(keys.bits(dimension), column));
        const std::uint32_t inRow = permuted(column, columns_, keyOfLine(keys.bits({dimension.index + 1}), row));
        within = {(inColumn + within.x()) / rows_, (inRow + within.y()) / columns_};
    }
    // The sums may round up.
    return {std::min((column + within.x()) / columns_, belowOne), std::min((row + within.y()) / rows_, belowOne)};
    //! [ex-10.2]
}

}  // namespace caustic
