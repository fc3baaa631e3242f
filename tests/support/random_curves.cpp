#include "support/random_curves.h"

#include <algorithm>

namespace caustic::test {

namespace {

Vec3 randomPoint(Random& random) {
    const Real x = random.uniform(-1, 1);
    const Real y = random.uniform(-1, 1);
    const Real z = random.uniform(-1, 1);
    return {x, y, z};
}

std::vector<Vec3> randomPoints(Random& random, int count) {
    std::vector<Vec3> points;
    for (int i = 0; i < count; ++i) points.push_back(randomPoint(random));
    return points;
}

}  // namespace

BezierCurve randomCurve(Random& random, int degree) { return BezierCurve(randomPoints(random, degree + 1)); }

BezierCurve randomCusp(Random& random, int degree) {
    // (t - c) is (-c, 1-c) in Bernstein form; the product's coefficients are those of g, weighted and shifted.
    const Real c = random.uniform(0.1, 0.9);
    const std::vector<Vec3> g = randomPoints(random, degree - 1);
    const auto last = g.size();
    std::vector<Vec3> points = {randomPoint(random)};
    for (std::size_t i = 0; i <= last; ++i) {
        Vec3 velocity = Vec3::Zero();
        if (i < last) velocity += static_cast<Real>(last - i) / static_cast<Real>(last) * -c * g[i];
        if (i > 0) velocity += static_cast<Real>(i) / static_cast<Real>(last) * (1 - c) * g[i - 1];
        points.push_back(points.back() + velocity);
    }
    return BezierCurve(points);
}

BezierCurve randomLoop(Random& random, int degree) {
    std::vector<Vec3> points = randomPoints(random, degree + 1);
    points.back() = points.front();
    return BezierCurve(points);
}

BezierCurve randomCoincident(Random& random, int degree) {
    std::vector<Vec3> points = randomPoints(random, degree + 1);
    for (std::size_t i = 1; i < points.size(); ++i) {
        const bool nearEnd = i == 1 || i + 1 == points.size();
        if (random.uniform() < (nearEnd ? 0.7 : 0.4)) points[i] = points[i - 1];
    }
    return BezierCurve(points);
}

BezierCurve randomCollinear(Random& random, int degree) {
    const Vec3 origin = randomPoint(random);
    const Vec3 direction = randomPoint(random);
    std::vector<Vec3> points;
    for (int i = 0; i <= degree; ++i) points.push_back(origin + random.uniform(-1, 1) * direction);
    return BezierCurve(points);
}

std::vector<NamedCurve> randomCurves(std::uint64_t seed, int count) {
    struct Kind {
        const char* name;
        BezierCurve (*make)(Random&, int);
        int lowestDegree;
    };
    constexpr Kind kinds[] = {{"random", randomCurve, 1},
                              {"cusp", randomCusp, 2},
                              {"loop", randomLoop, 2},
                              {"coincident control points", randomCoincident, 1},
                              {"collinear", randomCollinear, 1}};
    std::vector<NamedCurve> curves;
    for (int i = 0; i < count; ++i) {
        Random random(seed, {static_cast<std::uint64_t>(i)});
        const Kind& kind = kinds[i % 5];
        const int degree = std::max(kind.lowestDegree, 1 + i / 5 % 12);
        curves.push_back({std::string(kind.name) + ", degree " + std::to_string(degree) + ", number " +
                              std::to_string(i) + " of seed " + std::to_string(seed),
                          kind.make(random, degree)});
    }
    return curves;
}

}  // namespace caustic::test
