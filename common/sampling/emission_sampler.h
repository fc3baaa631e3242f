#pragma once

#include "sampling/sampler.h"

namespace caustic {

/// Where in its cell of a grid a point lies.
enum class CellPlace {
    Centre,    ///< in the middle: the same in each cell, and so a pattern that shows
    Jittered,  ///< anywhere, at random
    Offset     ///< at random, but so that the cells of a column lie side by side in x, and those of a row in y: each
               ///< coordinate alone is as evenly spread as if it had all the points for itself
};

/// Spreads the photons of a pass: of columns × rows photons one after the other, each has its pair in a cell of its own
/// of a grid, both for the place and for the direction of emission. Which photon gets which cell is shuffled for each
/// of the two, and anew for each pass. All other numbers are plain random ones. Source: Cook 1986 (jittered); Chiu,
/// Shirley, Wang 1994, Multi-jittered Sampling, Graphics Gems IV (offset).
class EmissionSampler final : public Sampler {
public:
    /// @param seed     of everything
    /// @param columns  of the grid, at least 1: cells along a pair's first number
    /// @param rows     at least 1; columns · rows at most 2³¹
    /// @throws InputError otherwise
    EmissionSampler(std::uint64_t seed, std::int64_t columns, std::int64_t rows, CellPlace place);

    Real number(const PathName& path, Dimension dimension) const override;
    Vec2 pair(const PathName& path, Dimension dimension) const override;

    /// The point of a cell.
    /// @param cell  row · columns + column
    /// @param path  whose round decides the offsets, and whose numbers the place within them
    Vec2 pointOf(std::uint32_t cell, const PathName& path, Dimension dimension) const;

private:
    std::int64_t round(const PathName& path) const { return path.index / (std::int64_t{columns_} * rows_); }

    std::uint64_t seed_;
    std::uint32_t columns_;
    std::uint32_t rows_;
    CellPlace place_;
};

}  // namespace caustic
