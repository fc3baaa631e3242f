#include "support/density_test.h"

#include <algorithm>
#include <numbers>
#include <numeric>

#include "support/chi_square.h"

namespace caustic::test {

namespace {

// Of the two-point Gauss rule, in lengths of the interval from its middle.
constexpr Real gaussNode = std::numbers::inv_sqrt3 / 2;

}  // namespace

DensityTest::DensityTest(const Cells& cells, int samples, std::uint64_t seed)
    : cells_(cells), samples_(samples), seed_(seed) {
    for (const int parts : cells.cells) count_ *= static_cast<std::size_t>(parts);
}

double DensityTest::probability(const PlaceSampling& sampling) {
    const std::vector<double> observed = drawn(sampling);
    std::vector<double> expected = integrals(sampling);
    // Quadrature may overshoot by a little, no more: who claims too much is wrong.
    const double sum = std::accumulate(expected.begin(), expected.end(), 0.0);
    if (sum > samples_ * (1 + 1e-4)) return 0;
    for (double& one : expected) one *= samples_ / sum;
    for (std::size_t cell = 0; cell <= count_; ++cell) {
        std::size_t octant = failures;
        if (cell < count_) {
            Place centre{};
            std::size_t rest = cell;
            for (std::size_t axis = 0; axis < 4; ++axis) {
                const auto parts = static_cast<std::size_t>(cells_.cells[axis]);
                centre[axis] = (static_cast<Real>(rest % parts) + 0.5) / static_cast<Real>(parts);
                rest /= parts;
            }
            octant = slot(centre, cells_.octants);
        }
        observed_[octant] += observed[cell];
        expected_[octant] += expected[cell];
    }
    ++configurations_;
    return chiSquareProbability(observed, expected);
}

double DensityTest::octantProbability(double error) const {
    const double all = std::accumulate(expected_.begin(), expected_.end(), 0.0);
    const auto fullest = std::max_element(expected_.begin(), expected_.begin() + failures);
    std::vector<double> claimed;
    for (const double& one : expected_)
        claimed.push_back(&one == fullest ? one * (1 + error) : one * (1 - error * *fullest / (all - *fullest)));
    return chiSquareProbability({observed_.begin(), observed_.end()}, claimed);
}

std::size_t DensityTest::slot(const Place& place, const std::array<int, 4>& parts) const {
    std::size_t slot = 0;
    for (std::size_t axis = 4; axis-- > 0;) {
        const int part = std::clamp(static_cast<int>(place[axis] * parts[axis]), 0, parts[axis] - 1);
        slot = slot * static_cast<std::size_t>(parts[axis]) + static_cast<std::size_t>(part);
    }
    return slot;
}

std::vector<double> DensityTest::drawn(const PlaceSampling& sampling) {
    std::vector<double> observed(count_ + 1);
    Random random(seed_, {static_cast<std::uint64_t>(configurations_)});
    for (int i = 0; i < samples_; ++i) {
        const auto place = sampling.sample(random);
        observed[place ? slot(*place, cells_.cells) : count_] += 1;
    }
    return observed;
}

std::vector<double> DensityTest::integrals(const PlaceSampling& sampling) const {
    std::vector<double> expected;
    double sum = 0;
    for (std::size_t cell = 0; cell < count_; ++cell) {
        expected.push_back(samples_ * integral(sampling, cell));
        sum += expected.back();
    }
    expected.push_back(std::max(0.0, samples_ - sum));
    return expected;
}

double DensityTest::integral(const PlaceSampling& sampling, std::size_t cell) const {
    std::array<Real, 4> low{};
    std::array<int, 4> steps{};
    int points = 1;
    std::size_t rest = cell;
    for (std::size_t axis = 0; axis < 4; ++axis) {
        const auto parts = static_cast<std::size_t>(cells_.cells[axis]);
        low[axis] = static_cast<Real>(rest % parts) / static_cast<Real>(parts);
        rest /= parts;
        steps[axis] = parts > 1 ? cells_.inner : 1;
        points *= steps[axis];
    }
    double sum = 0;
    for (int i = 0; i < points; ++i) {
        Place place{};
        int left = i;
        for (std::size_t axis = 0; axis < 4; ++axis) {
            const int step = left % steps[axis];
            left /= steps[axis];
            if (steps[axis] == 1) continue;
            const Real inPair = step / 2 + 0.5 + (step % 2 == 0 ? -gaussNode : gaussNode);
            place[axis] = low[axis] + 2 * inPair / (steps[axis] * cells_.cells[axis]);
        }
        sum += sampling.density(place);
    }
    return sum / (static_cast<double>(points) * static_cast<double>(count_));
}

}  // namespace caustic::test
