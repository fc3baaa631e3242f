#include "texture/image_distribution.h"

#include <algorithm>
#include <string>

#include "core/error.h"
#include "core/not_implemented.h"
#include "core/text.h"

namespace caustic {

namespace {

// In pixels: the border, the centres, the other border.
std::vector<Real> nodesOf(int size) {
    std::vector<Real> nodes = {0};
    for (int i = 0; i < size; ++i) nodes.push_back(i + 0.5);
    nodes.push_back(size);
    return nodes;
}

std::vector<Real> scaled(std::vector<Real> nodes, const std::function<Real(Real)>& map) {
    const Real size = nodes.back();
    for (Real& node : nodes) node = map(node / size);
    return nodes;
}

// The largest channel at each node.
std::vector<Real> brightnessOf(const Image& image, Wrap wrapX, Wrap wrapY) {
    std::vector<Real> nodes;
    for (const Real y : nodesOf(image.height())) {
        for (const Real x : nodesOf(image.width())) {
            const Color color = image.bilinear(x, y, wrapX, wrapY);
            if (!(color >= 0).all())
                throw InputError({"image", 0}, formatReal(color.minCoeff()), "brightness must be at least 0");
            nodes.push_back(color.maxCoeff());
        }
    }
    return nodes;
}

// Which of the intervals between nodes a number is in.
std::size_t intervalOf(const std::vector<Real>& nodes, Real at) {
    const auto above = std::upper_bound(nodes.begin() + 1, nodes.end() - 1, at);
    return static_cast<std::size_t>(above - nodes.begin()) - 1;
}

}  // namespace

ImageDistribution::ImageDistribution(const Image& image, Wrap wrapX, Wrap wrapY,
                                     const std::function<Real(Real)>& heightOf)
    : us_(scaled(nodesOf(image.width()), [](Real u) { return u; })),
      hs_(scaled(nodesOf(image.height()), heightOf)),
      nodes_(brightnessOf(image, wrapX, wrapY)),
      cells_(cellWeights(), us_.size() - 1) {}

// Brightness times area, row by row: so the sum is the mean over the square.
std::vector<Real> ImageDistribution::cellWeights() const {
    //! [ex-11.1]
    std::vector<Real> weights;
    for (std::size_t row = 0; row + 1 < hs_.size(); ++row) {
        for (std::size_t column = 0; column + 1 < us_.size(); ++column) {
            const Cell one = cell(column, row);
            weights.push_back(one.brightness.mean() * one.sides.prod());
        }
    }
    return weights;
    //! [ex-11.1]
}

ImageDistribution::Sample ImageDistribution::sample(const Vec2& u) const {
    //! [ex-11.2]
    const GridDistribution::Choice chosen = cells_.choose(u);
    const Cell one = cell(chosen.column, chosen.row);
    const Vec2 inside = one.brightness.sample(chosen.rest);
    // The cell's probability over its area, times the density within: brightness · area / sum · 1/area · value / mean.
    return {one.corner + one.sides.cwiseProduct(inside), one.brightness.value(inside) / mean()};
    //! [ex-11.2]
}

Real ImageDistribution::pdf(const Vec2& at) const {
    const Cell one = cell(intervalOf(us_, at.x()), intervalOf(hs_, at.y()));
    const Vec2 inside = (at - one.corner).cwiseQuotient(one.sides).cwiseMax(0).cwiseMin(1);
    // As in sample.
    return one.brightness.value(inside) / mean();
}

ImageDistribution::Cell ImageDistribution::cell(std::size_t column, std::size_t row) const {
    const Vec2 corner(us_[column], hs_[row]);
    return {corner,
            Vec2(us_[column + 1], hs_[row + 1]) - corner,
            {node(column, row), node(column + 1, row), node(column, row + 1), node(column + 1, row + 1)}};
}

}  // namespace caustic
