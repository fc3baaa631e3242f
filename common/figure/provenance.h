#pragma once

#include "figure/figure.h"

namespace caustic {

/// What making one figure cost.
struct FigureCost {
    double seconds = 0;  ///< wall time
    double peakMiB = 0;  ///< most memory that the process held while the figure was made
};

/// Watches the clock and the memory from its construction on.
class CostMeter {
public:
    /// Starts the clock.
    CostMeter();

    /// What it cost so far.
    FigureCost cost() const;

private:
    double start_;
};

/// Enters a figure into `out/chapter/provenance.json`: what it was made from (hashes of sources and assets, seed,
/// quality, threads) and what it cost. Entries of other figures stay as they are.
/// @throws InputError when the file that is there is no JSON, or cannot be written
void recordProvenance(const ChapterInputs& inputs, const ChapterOptions& options, const Figure& figure,
                      const FigureContext& context, const FigureCost& cost);

}  // namespace caustic
