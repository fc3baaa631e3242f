#include "patterns.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/random.h"
#include "math/vector.h"

namespace caustic {

namespace {

using std::numbers::pi;

Real smooth(Real t) { return t * t * (3 - 2 * t); }

// A number in [0, 1) for each cell of a lattice that repeats: its name, mixed twice. There are many to make.
Real latticeValue(int x, int y, int period, std::uint64_t seed) {
    const auto inside = [period](int i) { return static_cast<std::uint64_t>((i % period + period) % period); };
    std::uint64_t bits = (inside(x) << 32 | inside(y)) ^ seed * 0x9e3779b97f4a7c15ULL;
    for (int round = 0; round < 2; ++round) {
        bits ^= bits >> 32;
        bits *= 0xd6e8feb86659fd93ULL;
    }
    return static_cast<Real>(bits >> 11) * 0x1p-53;
}

// Perlin's value noise, 1985: smooth between the values of the lattice.
Real noise(Real x, Real y, int period, std::uint64_t seed) {
    const int column = static_cast<int>(std::floor(x));
    const int row = static_cast<int>(std::floor(y));
    const Real s = smooth(x - column);
    const Real upper =
        std::lerp(latticeValue(column, row, period, seed), latticeValue(column + 1, row, period, seed), s);
    const Real lower =
        std::lerp(latticeValue(column, row + 1, period, seed), latticeValue(column + 1, row + 1, period, seed), s);
    return std::lerp(upper, lower, smooth(y - row));
}

// Four octaves of it, u and v in [0, 1].
Real cloud(Real u, Real v, int across, int along, std::uint64_t seed) {
    Real sum = 0;
    Real weight = 0.5;
    for (int octave = 0; octave < 4; ++octave, weight /= 2) {
        const int scale = 1 << octave;
        sum +=
            weight * noise(u * across * scale, v * along * scale, 1 << 16, seed + static_cast<std::uint64_t>(octave));
    }
    return sum;
}

}  // namespace

Image woodPattern(int width, int height, std::uint64_t seed) {
    constexpr int planks = 4;
    const Color dark(0.05, 0.02, 0.008);
    const Color light(0.33, 0.18, 0.085);
    Image image(width, height);
    for (int y = 0; y < height; ++y) {
        const Real across = (y + 0.5) / height * planks;
        const int plank = static_cast<int>(across);
        const Real inPlank = across - plank;
        const std::uint64_t own = seed + 100 * static_cast<std::uint64_t>(plank);
        const Real tone = Random(own, {1}).uniform(-0.14, 0.14);
        for (int x = 0; x < width; ++x) {
            const Real u = (x + 0.5) / width;
            // Rings of a trunk that lies nearly along the plank, bent by what the tree lived through.
            const Real bend = cloud(u, inPlank, 3, 2, own);
            const Real ring = 0.5 + 0.5 * std::sin(2 * pi * (7 * inPlank + 5 * bend));
            const Real fibre = cloud(u, inPlank, 12, 160, own + 50);
            const Real pores = std::pow(cloud(u, inPlank, 40, 300, own + 60), 4);
            const Real mix =
                std::clamp(0.12 + tone + 0.5 * ring * (0.5 + bend) + 0.6 * (fibre - 0.45) - 1.2 * pores, 0.0, 1.0);
            const Real edge = std::min(inPlank, 1 - inPlank) * height / planks;
            const Real gap = edge < 2.5 ? 0.25 + 0.3 * edge : 1;
            image.set(x, y, std::min(gap, 1.0) * (dark + mix * (light - dark)));
        }
    }
    return image;
}

Image windowPattern(int width, int height) {
    constexpr int columns = 2;
    constexpr int rows = 3;
    constexpr Real lead = 0.06;
    Image image(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const Vec2 pane(std::fmod((x + 0.5) / width * columns, 1), std::fmod((y + 0.5) / height * rows, 1));
            const Vec2 fromEdge = pane.cwiseMin(Vec2::Ones() - pane);
            if (fromEdge.minCoeff() < lead) continue;
            const Real up = 1 - (y + 0.5) / height;
            image.set(x, y, (0.7 + 0.5 * up) * Color(0.85 + 0.15 * (1 - up), 0.95, 1.05));
        }
    }
    return image;
}

Image hammeredPattern(int side, int dents, Real depth, std::uint64_t seed) {
    Image image(side, side);
    const Real cell = Real(side) / dents;
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            // The deepest dent of those around: each a bowl about a jittered centre.
            Real lowest = 1;
            for (int k = 0; k < 9; ++k) {
                const int column = static_cast<int>(x / cell) + k % 3 - 1;
                const int row = static_cast<int>(y / cell) + k / 3 - 1;
                const Vec2 centre(column + 0.2 + 0.6 * latticeValue(column, row, dents, seed),
                                  row + 0.2 + 0.6 * latticeValue(column, row, dents, seed + 1));
                const Real squared = (Vec2(x + 0.5, y + 0.5) / cell - centre).squaredNorm();
                lowest = std::min(lowest, squared);
            }
            image.set(x, y, Color::Constant(depth * cell * 4 * lowest));
        }
    }
    return image;
}

Image flutedPattern(int width, int height, int flutes, Real from, Real to, Real slope) {
    Image image(width, height);
    const Real wave = 2 * pi * flutes / height;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const Real u = (x + 0.5) / width;
            const Real inside = std::clamp(std::min(u - from, to - u) / (0.1 * (to - from)), 0.0, 1.0);
            image.set(x, y, Color::Constant(slope / wave * smooth(inside) * std::cos(wave * (y + 0.5))));
        }
    }
    return image;
}

}  // namespace caustic
