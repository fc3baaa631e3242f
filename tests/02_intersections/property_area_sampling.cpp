#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "core/random.h"
#include "leaving.h"
#include "shape/box.h"
#include "shape/instance.h"
#include "shape/plane.h"
#include "shape/ring_cylinder.h"
#include "shape/sphere.h"
#include "shape/triangle.h"
#include "support/chi_square.h"

namespace caustic {
namespace {

constexpr Real pi = std::numbers::pi;
constexpr int samples = 1'000'000;
constexpr double falseAlarm = 1e-6;

AreaSample sampleOf(const Shape& shape, int i) {
    Random random(1, {static_cast<std::uint64_t>(i)});
    return *shape.sampleArea({random.uniform(), random.uniform()});
}

// Whether samples fall into cells as the cells' areas say. `cellOf` numbers the cells of the surface.
void expectAreas(const Shape& shape, const std::vector<double>& areas,
                 const std::function<std::size_t(const SurfacePoint&)>& cellOf) {
    double total = 0;
    for (const double area : areas) total += area;
    std::vector<double> observed(areas.size());
    std::vector<double> expected;
    for (const double area : areas) expected.push_back(samples * area / total);
    for (int i = 0; i < samples; ++i) {
        const AreaSample sample = sampleOf(shape, i);
        ASSERT_NEAR(sample.pdfA, 1 / total, 1e-12 / total) << "Is pdfA one over the whole area?";
        observed[cellOf(sample.at)] += 1;
    }
    EXPECT_GT(test::chiSquareProbability(observed, expected), falseAlarm);
}

std::size_t slot(Real value, std::size_t slots) {
    return std::min(static_cast<std::size_t>(value * static_cast<Real>(slots)), slots - 1);
}

// Archimedes: a slice of a sphere has the area 2πr · thickness.
TEST(AreaSampling, SphereIsUniform) {
    const Sphere sphere(Vec3(1, 2, 3), 0.7);
    std::vector<double> areas(8 * 10, 4 * pi * 0.49 / 80);
    expectAreas(sphere, areas,
                [&](const SurfacePoint& at) { return 8 * slot((at.ng.y() + 1) / 2, 10) + slot(at.uv.x(), 8); });
}

TEST(AreaSampling, BoxIsUniformOverItsFaces) {
    const Box box(Vec3(-1, 0, 2), Vec3(1, 0.5, 5));
    const double faces[] = {0.5 * 3, 2.0 * 3, 2.0 * 0.5};
    std::vector<double> areas;
    for (const double face : faces) areas.insert(areas.end(), 2 * 16, face / 16);
    expectAreas(box, areas, [&](const SurfacePoint& at) {
        int axis = 0;
        at.ng.cwiseAbs().maxCoeff(&axis);
        const std::size_t face = static_cast<std::size_t>(2 * axis + (at.ng[axis] > 0 ? 1 : 0));
        return 16 * face + 4 * slot(at.uv.x(), 4) + slot(at.uv.y(), 4);
    });
}

// Halving both sides cuts a triangle into four of equal area; so does each of these.
TEST(AreaSampling, TriangleIsUniform) {
    const Triangle triangle(Vec3(0, 0, 0), Vec3(3, 0, 1), Vec3(0.5, 2, 0));
    const double area = Vec3(3, 0, 1).cross(Vec3(0.5, 2, 0)).norm() / 2;
    expectAreas(triangle, std::vector<double>(16, area / 16), [](const SurfacePoint& at) {
        Vec2 b = at.uv;
        std::size_t cell = 0;
        for (int level = 0; level < 2; ++level) {
            b *= 2;
            std::size_t part = 0;
            if (b.x() >= 1) {
                part = 1;
                b.x() -= 1;
            } else if (b.y() >= 1) {
                part = 2;
                b.y() -= 1;
            } else if (b.sum() >= 1) {
                part = 3;
                b = Vec2::Ones() - b;
            }
            cell = 4 * cell + part;
        }
        return cell;
    });
}

// Cells: eighths of the angle, times four parts, times four equal areas of each (r² on discs, y on walls).
TEST(AreaSampling, RingCylinderIsUniformOverItsParts) {
    const Real inner = 0.4;
    const Real outer = 1.1;
    const Real bottom = -0.5;
    const Real top = 1.5;
    for (const Real hole : {inner, 0.0}) {
        const RingCylinder ring(hole, outer, bottom, top);
        const double disc = pi * (outer * outer - hole * hole);
        std::vector<double> areas(4 * 32, disc / 32);
        std::fill_n(areas.begin() + 2 * 32, 32, 2 * pi * outer * (top - bottom) / 32);
        std::fill_n(areas.begin() + 3 * 32, 32, 2 * pi * hole * (top - bottom) / 32);
        expectAreas(ring, areas, [&](const SurfacePoint& at) {
            const Real r = std::hypot(at.point.x(), at.point.z());
            const bool cap = std::abs(at.ng.y()) > 0.5;
            const bool outwards = at.ng.x() * at.point.x() + at.ng.z() * at.point.z() > 0;
            const std::size_t part = cap ? (at.ng.y() > 0 ? 1 : 0) : (outwards ? 2 : 3);
            const Real share =
                cap ? (r * r - hole * hole) / (outer * outer - hole * hole) : (at.point.y() - bottom) / (top - bottom);
            return 32 * part + 4 * slot(at.uv.x(), 8) + slot(std::max(share, 0.0), 4);
        });
    }
}

// Monte Carlo: the mean of 1 / pdfA is the area. An oblate spheroid with semi-axes a, a, c < a has the area
// 2πa² + π c²/e · ln((1 + e)/(1 - e)), e² = 1 - c²/a².
TEST(AreaSampling, StretchedSphereHasTheSpheroidsArea) {
    const Real a = 2;
    const Real c = 0.5;
    const Real e = std::sqrt(1 - c * c / (a * a));
    const Real area = 2 * pi * a * a + pi * c * c / e * std::log((1 + e) / (1 - e));
    const auto sphere = std::make_shared<Sphere>(Vec3::Zero(), 1.0);
    const Instance spheroid(sphere, Transform::rotation({1, 1, 0}, 1) * Transform::scaling({a, -c, a}));
    Real sum = 0;
    Real sumOfSquares = 0;
    for (int i = 0; i < samples; ++i) {
        const AreaSample sample = sampleOf(spheroid, i);
        sum += 1 / sample.pdfA;
        sumOfSquares += 1 / (sample.pdfA * sample.pdfA);
        EXPECT_NEAR(spheroid.pdfA(sample.at), sample.pdfA, 1e-12 * sample.pdfA);
    }
    const Real mean = sum / samples;
    const Real error = std::sqrt((sumOfSquares / samples - mean * mean) / samples);
    // 4.9 standard errors: two-sided false alarm of 1e-6.
    EXPECT_NEAR(mean, area, 4.9 * error);
    EXPECT_LT(4.9 * error, 0.01 * area) << "This test must be able to tell a mean that is off by 1 %.";
}

// The same surface twice: a box stretched by a transform, and the stretched box itself.
TEST(AreaSampling, StretchedBoxHasTheDensityOfItsFaces) {
    const Vec3 size(1, 2, 4);
    const auto cube = std::make_shared<Box>(Vec3::Zero(), Vec3::Ones());
    const Instance stretched(cube, Transform::scaling(size));
    // A third of the samples goes to each pair of faces, however large it is: pdfA = 1/6 over the face's area.
    for (int i = 0; i < 1000; ++i) {
        const AreaSample sample = sampleOf(stretched, i);
        int axis = 0;
        sample.at.ng.cwiseAbs().maxCoeff(&axis);
        const Real faceArea = size.prod() / size[axis];
        EXPECT_NEAR(sample.pdfA, 1 / (6 * faceArea), 1e-14);
    }
}

TEST(AreaSampling, EndsOfTheUnitSquareStayOnTheSurface) {
    const Real last = 1 - 0x1p-53;
    const std::shared_ptr<const Shape> shapes[] = {
        std::make_shared<Sphere>(Vec3::Zero(), 1.0), std::make_shared<Box>(Vec3::Zero(), Vec3(1, 2, 3)),
        std::make_shared<Triangle>(Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY()),
        std::make_shared<RingCylinder>(0.5, 1.0, 0.0, 1.0), std::make_shared<RingCylinder>(0.0, 1.0, 0.0, 1.0)};
    for (const auto& shape : shapes) {
        for (const Vec2& u : {Vec2(0, 0), Vec2(0, last), Vec2(last, 0), Vec2(last, last)}) {
            const auto sample = shape->sampleArea(u);
            ASSERT_TRUE(sample);
            EXPECT_TRUE(sample->at.point.allFinite() && sample->at.ng.allFinite() && sample->at.uv.allFinite());
            EXPECT_LE(shape->bounds().exteriorDistance(sample->at.point), 1e-15);
            EXPECT_GT(sample->pdfA, 0);
        }
    }
    EXPECT_FALSE(Plane(Vec3::Zero(), Vec3::UnitY()).sampleArea({0.5, 0.5}));
}

// The chi-square test's power: a density that is wrong by 3 % in one octant is rejected, the right one is not.
TEST(AreaSampling, TestRejectsThreePercentInOneOctant) {
    const auto probability = [](double excess) {
        std::vector<double> observed(8);
        for (int i = 0; i < samples; ++i) {
            Random random(2, {static_cast<std::uint64_t>(i)});
            const Real total = 8 + excess;
            const Real place = random.uniform(0, total);
            observed[place < 1 + excess ? 0 : static_cast<std::size_t>(place - excess)] += 1;
        }
        return test::chiSquareProbability(observed, std::vector<double>(8, samples / 8.0));
    };
    EXPECT_LT(probability(0.03), falseAlarm);
    EXPECT_GT(probability(0), falseAlarm);
}

}  // namespace
}  // namespace caustic
