#include "support/direction_chi_square.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/random.h"
#include "support/chi_square.h"
#include "support/sphere_integral.h"

namespace caustic::test {

namespace {

constexpr double pi = std::numbers::pi;
constexpr int bands = 24;
constexpr int sectors = 48;

std::size_t cellOf(const Vec2& place) {
    const int band = std::clamp(static_cast<int>((place.y() + 1) / 2 * bands), 0, bands - 1);
    const int sector = std::clamp(static_cast<int>((place.x() / (2 * pi) + 0.5) * sectors), 0, sectors - 1);
    return static_cast<std::size_t>(band * sectors + sector);
}

SpherePatch patchOf(int cell) {
    const int band = cell / sectors;
    const int sector = cell % sectors;
    return {2.0 * band / bands - 1, 2.0 * (band + 1) / bands - 1, 2 * pi * sector / sectors - pi,
            2 * pi * (sector + 1) / sectors - pi};
}

// The eight octants and what failed.
std::vector<double> octants(const std::vector<double>& cells) {
    std::vector<double> sums(9);
    for (int cell = 0; cell < bands * sectors; ++cell) {
        const int octant = (cell / sectors < bands / 2 ? 4 : 0) + cell % sectors / (sectors / 4);
        sums[static_cast<std::size_t>(octant)] += cells[static_cast<std::size_t>(cell)];
    }
    sums.back() = cells.back();
    return sums;
}

}  // namespace

double directionProbability(const DirectionSampling& sampling, int samples, std::uint64_t seed, const Frame& axes) {
    constexpr std::size_t cells = bands * sectors;
    std::vector<std::vector<Vec2>> seen(cells);
    double failed = 0;
    for (int i = 0; i < samples; ++i) {
        Random random(seed, {static_cast<std::uint64_t>(i)});
        const double x = random.uniform();
        const double y = random.uniform();
        const auto direction = sampling.sample({x, y}, random.uniform());
        if (!direction) {
            failed += 1;
            continue;
        }
        const Vec2 place = placeOnSphere(axes.toLocal(*direction));
        seen[cellOf(place)].push_back(place);
    }
    const auto density = [&](const Vec3& local) { return sampling.pdfW(axes.toWorld(local)); };
    std::vector<double> observed;
    std::vector<double> integrals;
    double sum = 0;
    for (std::size_t cell = 0; cell < cells; ++cell) {
        observed.push_back(static_cast<double>(seen[cell].size()));
        integrals.push_back(samples *
                            sphereIntegral(density, patchOf(static_cast<int>(cell)), 0.05 / samples, seen[cell]));
        sum += integrals.back();
    }
    observed.push_back(failed);
    if (sum > samples + std::sqrt(samples)) return 0;  // no density: it sums to more than 1
    if (sum < 0.5 && failed == samples) return 1;      // both say that there is nothing
    std::vector<double> expected = integrals;
    expected.push_back(std::max(0.5, samples - sum));
    for (std::size_t cell = 0; cell < cells; ++cell) {
        // The density's edge may cut a corner off the cell, between the points of the rule.
        const auto inside = [&](const Vec2& place) { return density(directionAt(place)) > 0; };
        if (expected[cell] > 0 || std::none_of(seen[cell].begin(), seen[cell].end(), inside)) continue;
        expected[cell] = 1e-3;
        sum += 1e-3;
    }
    // What the rule leaves open, and the corners.
    const double scale = samples / (sum + expected.back());
    for (double& one : expected) one *= scale;
    // Cells see what is narrow, octants what is broad and faint: the less likely of the two, which has two chances.
    const double finely = chiSquareProbability(observed, expected);
    const std::vector<double> broad = octants(expected);
    if (std::count_if(broad.begin(), broad.end(), [](double one) { return one >= 5; }) < 2) return finely;
    return std::min(1.0, 2 * std::min(finely, chiSquareProbability(octants(observed), broad)));
}

}  // namespace caustic::test
