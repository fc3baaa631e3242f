#pragma once

#include <functional>

#include "image/image.h"
#include "sampling/bilinear_density.h"
#include "sampling/grid_distribution.h"

namespace caustic {

/// Picks places of an image in proportion to its brightness, the largest channel of its bilinear look-up. Places are
/// (u, h) in [0, 1]²: u = x / width, and h says how much of the whole lies above a row. On a rectangle h is
/// y / height; on a sphere the rows at the poles hold less, h = (1 − cos θ)/2. So equal areas of (u, h) are equal areas
/// of what the image is laid on.
///
/// Between the centres of four neighbouring pixels the brightness is taken as bilinear in (u, h), with its true value
/// in the corners. Where the image is not black, the density isn't 0; and no brightness over the density is more than
/// twice the mean brightness, or than the mean where h is y / height.
class ImageDistribution {
public:
    /// A place and the density over the unit square with which it is picked.
    struct Sample {
        Vec2 at = Vec2::Zero();
        Real pdf = 0;
    };

    /// @param heightOf  h of y / height: rises from 0 to 1
    /// @throws InputError when a value is negative, or all are 0
    ImageDistribution(const Image& image, Wrap wrapX, Wrap wrapY, const std::function<Real(Real)>& heightOf);

    /// Picks a place.
    /// @param u  two uniform numbers in [0, 1)
    Sample sample(const Vec2& u) const;

    /// The density with which a place is picked.
    /// @param at  in [0, 1]²
    Real pdf(const Vec2& at) const;

    /// The mean brightness over the unit square.
    Real mean() const { return cells_.sum(); }

private:
    struct Cell {
        Vec2 corner;  // with the smaller u and h
        Vec2 sides;
        BilinearDensity brightness;
    };

    std::vector<Real> cellWeights() const;
    Cell cell(std::size_t column, std::size_t row) const;
    Real node(std::size_t column, std::size_t row) const { return nodes_[row * us_.size() + column]; }

    // Nodes are the pixels' centres and, on the image's border, what lies between the last ones; cells are between
    // nodes.
    std::vector<Real> us_;     // of the columns of nodes
    std::vector<Real> hs_;     // of the rows of nodes
    std::vector<Real> nodes_;  // their brightness, row by row
    GridDistribution cells_;
};

}  // namespace caustic
