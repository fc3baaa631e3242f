#pragma once

#include <vector>

#include "math/color.h"
#include "sampling/pixel.h"

namespace caustic {

/// What is known of a pixel's mean after some batches of paths, each of the same number. Whole batches are entered: the
/// paths of one may depend on each other (they share photons, or are spread evenly), those of different ones don't.
struct PixelEstimate {
    std::int64_t batches = 0;       ///< so far
    Color mean = Color::Zero();     ///< of them
    Color squares = Color::Zero();  ///< sum of the batches' squared distances from their mean

    /// Enters the mean of a batch. However large the mean is beside the noise, squares stay exact to a few roundings.
    /// Source: Welford 1962, Note on a Method for Calculating Corrected Sums of Squares and Products.
    void add(const Color& batch);

    /// Estimated variance of `mean`, of each channel; infinite before the second batch.
    Color variance() const;

    /// Half the width of the interval around `mean` in which the true mean lies as often as a normal variable lies
    /// within `deviations` of its own, of each channel; infinite before the second batch. The fewer batches the wider,
    /// since the variance is an estimate as well: Student's t.
    /// @param deviations  greater than 0; 1.96 for 95 %
    Color halfWidth(Real deviations) const;
};

/// Where Student's t, of so many degrees of freedom, has the tail that a normal variable has beyond `deviations`. Off
/// by less than 0.2 % from three degrees on and 2 % with two, for up to two deviations; with one it is a lower bound.
/// Source: Fisher, Cornish 1960; Abramowitz, Stegun, 26.7.5.
/// @param deviations  greater than 0
/// @param degrees     of freedom, at least 1
Real studentT(Real deviations, std::int64_t degrees);

/// The estimates of all pixels of a picture.
class PixelEstimates {
public:
    /// None has a batch yet.
    PixelEstimates(int width, int height);

    /// Pixels in a row.
    int width() const { return width_; }
    /// Rows.
    int height() const { return height_; }
    /// How many pixels there are.
    std::size_t size() const { return pixels_.size(); }

    /// By place: row by row from the top.
    const PixelEstimate& operator[](std::size_t place) const { return pixels_[place]; }
    /// The same, to enter batches.
    PixelEstimate& operator[](std::size_t place) { return pixels_[place]; }

    /// Mean of all pixels and channels: what errors are compared with in the dark.
    Real brightness() const;

private:
    int width_;
    int height_;
    std::vector<PixelEstimate> pixels_;
};

}  // namespace caustic
