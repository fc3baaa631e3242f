#include "support/direction_chi_square.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/random.h"
#include "support/chi_square.h"

namespace caustic::test {

namespace {

constexpr double pi = std::numbers::pi;
constexpr int bands = 24;
constexpr int sectors = 48;
constexpr int inner = 16;  // points of the midpoint rule along either side of a cell

std::size_t cellOf(const Vec3& direction) {
    const double angle = std::atan2(direction.y(), direction.x()) / (2 * pi) + 0.5;
    const int band = std::clamp(static_cast<int>((direction.z() + 1) / 2 * bands), 0, bands - 1);
    const int sector = std::clamp(static_cast<int>(angle * sectors), 0, sectors - 1);
    return static_cast<std::size_t>(band * sectors + sector);
}

double integral(const DirectionSampling& sampling, int band, int sector) {
    double sum = 0;
    for (int i = 0; i < inner * inner; ++i) {
        const double z = 2 * (band + (i % inner + 0.5) / inner) / bands - 1;
        const double angle = 2 * pi * ((sector + (i / inner + 0.5) / inner) / sectors - 0.5);
        const double r = std::sqrt(1 - z * z);
        sum += sampling.pdfW({r * std::cos(angle), r * std::sin(angle), z});
    }
    return sum * 4 * pi / (bands * sectors * inner * inner);
}

// Whether one of the cells around has a density: its edge may cut this one between the points of the midpoint rule.
bool besideDensity(const std::vector<double>& expected, int cell) {
    for (int i = 0; i < 9; ++i) {
        const int band = cell / sectors + i / 3 - 1;
        const int sector = (cell % sectors + i % 3 - 1 + sectors) % sectors;
        if (band >= 0 && band < bands && expected[static_cast<std::size_t>(band * sectors + sector)] > 0) return true;
    }
    return false;
}

}  // namespace

double directionProbability(const DirectionSampling& sampling, int samples, std::uint64_t seed) {
    constexpr std::size_t cells = bands * sectors;
    std::vector<double> observed(cells + 1);  // the last one counts samples that failed
    for (int i = 0; i < samples; ++i) {
        Random random(seed, {static_cast<std::uint64_t>(i)});
        const double x = random.uniform();
        const double y = random.uniform();
        const auto direction = sampling.sample({x, y}, random.uniform());
        observed[direction ? cellOf(*direction) : cells] += 1;
    }
    std::vector<double> expected;
    double sum = 0;
    for (int cell = 0; cell < bands * sectors; ++cell) {
        expected.push_back(samples * integral(sampling, cell / sectors, cell % sectors));
        sum += expected.back();
    }
    const std::vector<double> integrals = expected;
    for (int cell = 0; cell < bands * sectors; ++cell) {
        double& one = expected[static_cast<std::size_t>(cell)];
        if (one > 0 || !besideDensity(integrals, cell)) continue;
        one = 0.5;
        sum += one;
    }
    expected.push_back(std::max(0.0, samples - sum));
    // The midpoint rule may overshoot by a little.
    const double scale = samples / (sum + expected.back());
    for (double& one : expected) one *= scale;
    return chiSquareProbability(observed, expected);
}

}  // namespace caustic::test
