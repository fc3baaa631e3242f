#pragma once

#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "core/random.h"
#include "math/real.h"

namespace caustic::test {

/// Coordinates of whatever is sampled, each in [0, 1]; those that a test doesn't use are 0.
using Place = std::array<Real, 4>;

/// A way to pick places, and the density over the unit cube that it claims. Samples may fail: what the density lacks to
/// an integral of 1 is how often they should. Coordinates in which the density is smooth up to the cube's faces are
/// integrated best.
struct PlaceSampling {
    std::function<std::optional<Place>(Random& random)> sample;
    std::function<Real(const Place& place)> density;
};

/// Into how many parts each coordinate is cut: a test's cells, and the eight octants that take many of them together.
/// A coordinate with one cell isn't used. Octants divide cells evenly.
struct Cells {
    std::array<int, 4> cells;
    std::array<int, 4> octants;
    int inner;  ///< points of quadrature along each used side of a cell: pairs by Gauss's rule, so an even number
};

/// Directions, points of a surface, and the like.
inline constexpr Cells planeCells = {{16, 16, 1, 1}, {2, 4, 1, 1}, 16};
/// Points of one of six faces.
inline constexpr Cells faceCells = {{6, 6, 6, 1}, {2, 2, 2, 1}, 4};
/// A place and a direction.
inline constexpr Cells rayCells = {{4, 4, 4, 4}, {2, 2, 2, 1}, 2};

/// Chi-square tests of one sampler in many configurations.
///
/// Each configuration is tested by itself, in cells. Too few samples fall into each to see small errors, so counts of
/// all configurations are added up by octants as well. Those are sums of multinomials with probabilities of their own,
/// which vary less than a single one would: the test is on the safe side.
class DensityTest {
public:
    /// @param samples  of each configuration
    DensityTest(const Cells& cells, int samples, std::uint64_t seed);

    /// Tests a configuration: the probability that counts of the claimed density differ from it at least as much as
    /// those of the samples do. Reject below 1e-6.
    double probability(const PlaceSampling& sampling);

    /// The same for the octants of all configurations so far, as if the claimed density were by the share `error` too
    /// large in the fullest octant, and too small by as much in all others together.
    double octantProbability(double error = 0) const;

    /// Configurations so far.
    int configurations() const { return configurations_; }

private:
    std::size_t slot(const Place& place, const std::array<int, 4>& parts) const;
    std::vector<double> drawn(const PlaceSampling& sampling);
    std::vector<double> integrals(const PlaceSampling& sampling) const;
    double integral(const PlaceSampling& sampling, std::size_t cell) const;

    Cells cells_;
    std::size_t count_ = 1;  // cells
    int samples_;
    std::uint64_t seed_;
    int configurations_ = 0;

    static constexpr std::size_t failures = 8;  // behind the octants
    std::array<double, failures + 1> observed_{};
    std::array<double, failures + 1> expected_{};
};

}  // namespace caustic::test
