#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <set>
#include <vector>

#include "integrator/scatter.h"
#include "integrator/walk.h"
#include "material/mirror_material.h"
#include "material/phong_material.h"
#include "material/refraction_material.h"
#include "shape/rectangle.h"
#include "support/coloured_fog.h"
#include "support/recording_sampler.h"
#include "texture/constant_texture.h"
#include "vertex_scenes.h"

namespace caustic {
namespace {

Scene of(const std::vector<SceneObject>& objects) { return Scene({objects, {}, Color::Zero(), nullptr}); }

// A plane off the origin, at y = 2, and where a ray meets it that comes down with this cosine.
Interaction onFloor(const Scene& scene, Real cosine) {
    const Vec3 down(std::sqrt(1 - cosine * cosine), -cosine, 0);
    const Vec3 point(3, 2, -5);
    return test::meet(scene, point - down, point);
}

SceneObject floor(const std::shared_ptr<const Material>& material, const Vec3& ns = Vec3::UnitY()) {
    return {test::leaningPlane({3, 2, -5}, Vec3::UnitY(), ns, 9), material, {}, nullptr};
}

const std::shared_ptr<const Material> shiny =
    std::make_shared<PhongMaterial>(std::make_shared<ConstantTexture>(Color(0.2, 0.4, 0.1)), Color(0.3, 0.1, 0.6), 12);

std::optional<Scattering> step(const Interaction& at, TransportMode mode, int index, int vertex = 0) {
    return scatter(at, mode, test::independent.start(0, {0, 0}, index), vertex);
}

// f |cos| / p: of a diffuse surface that is its reflectance, wherever the sample goes. On smooth normals, with a
// highlight: f and the cosine are those of the sample's direction and of what the path carries, the density is that of
// the direction. In a medium all goes on.
TEST(Scatter, WeighsTheDirectionThatItTakes) {
    const Scene plain = of({floor(test::diffuse(test::rho))});
    const Interaction onPlain = onFloor(plain, 0.3);
    for (int i = 0; i < 200; ++i) {
        const TransportMode mode = i % 2 == 0 ? TransportMode::Radiance : TransportMode::Importance;
        const auto next = step(onPlain, mode, i, i % 3);
        ASSERT_TRUE(next);
        EXPECT_GT(next->sample.wi.y(), 0);
        test::expectColor(next->weight, test::rho, "Is f multiplied by the cosine and divided by the density?");
    }
    const Vec3 ns = Vec3(0.3, 1, 0.1).normalized();
    const Scene scene = of({floor(shiny, ns)});
    const Interaction at = onFloor(scene, 0.5);
    for (const TransportMode mode : {TransportMode::Radiance, TransportMode::Importance}) {
        for (int i = 0; i < 500; ++i) {
            const auto next = step(at, mode, i);
            if (!next) continue;
            const Vec3& wi = next->sample.wi;
            const Color f = at.f(wi, mode);
            EXPECT_NEAR(next->sample.pdfW / at.pdfW(wi), 1, 1e-9) << "Is the sample handed on as it was drawn?";
            EXPECT_LE((next->sample.f - f).abs().maxCoeff(), 1e-9 * f.maxCoeff())
                << "Is the sample handed on as it was drawn? What does the path carry?";
            EXPECT_LE((next->weight - f * (std::abs(wi.dot(ns)) / at.pdfW(wi))).abs().maxCoeff(), 1e-9)
                << "Which cosine, and of which direction?";
        }
    }
    const test::ForwardPhase phase;
    const Vec3 wo(0.48, 0.6, 0.64);
    const Interaction inside({1, 2, 3}, wo, phase, {});
    for (int i = 0; i < 100; ++i) {
        const auto next = step(inside, TransportMode::Radiance, i);
        ASSERT_TRUE(next);
        test::expectColor(next->weight, Color::Constant(1 - wo.dot(next->sample.wi) / 2),
                          "Is there a cosine in a medium?");
    }
}

// A pair of numbers for the direction and one for the lobe, those of the vertex: they have nothing to do with each
// other, nor with those of the next vertex.
TEST(Scatter, TakesTheNumbersOfItsVertex) {
    const Scene scene = of({floor(shiny)});
    const Interaction at = onFloor(scene, 0.5);
    const test::RecordingSampler sampler;
    std::set<Real> directions;
    int count = 0;
    for (int vertex = 0; vertex < 5; ++vertex) {
        for (int i = 0; i < 100; ++i) {
            sampler.forget();
            const auto next = scatter(at, TransportMode::Radiance, sampler.start(0, {0, 0}, i), vertex);
            std::set<int> dimensions;
            for (const auto& asked : sampler.asked()) dimensions.insert(asked.dimension);
            const std::set<int> expected = {Dimension::vertex(vertex, VertexUse::Direction).index,
                                            Dimension::vertex(vertex, VertexUse::Lobe).index};
            EXPECT_EQ(dimensions, expected) << "VertexUse says what numbers are for. Whose vertex is it?";
            if (!next) continue;
            ++count;
            directions.insert(next->sample.wi.x());
        }
    }
    EXPECT_EQ(directions.size(), static_cast<std::size_t>(count)) << "Do two steps use the same numbers?";
}

// A delta lobe's f is what the direction's whole light is multiplied by, its density the probability of the lobe. Glass
// that reflects 0.3 and refracts 0.7 of the light picks its lobes so: each step carries all, in radiance divided by η²
// where it is refracted.
TEST(Scatter, DeltaLobesHaveNoCosine) {
    const Color R(0.2, 0.5, 0.8);
    const Scene mirrors = of({floor(std::make_shared<MirrorMaterial>(R))});
    const auto reflected = step(onFloor(mirrors, 0.3), TransportMode::Radiance, 0);
    ASSERT_TRUE(reflected);
    test::expectColor(reflected->weight, R, "Is there a cosine in it?");

    SceneObject glass = floor(std::make_shared<RefractionMaterial>(Color(0.1, 0.3, 0.2), Color(0.7, 0.4, 0.5)));
    glass.interior = Interior{1.5, nullptr, 0};
    const Scene scene = of({glass});
    const Interaction at = onFloor(scene, 0.4);
    constexpr int n = 20'000;
    int refractions = 0;
    for (int i = 0; i < n; ++i) {
        const TransportMode mode = i % 2 == 0 ? TransportMode::Radiance : TransportMode::Importance;
        const auto next = step(at, mode, i, 1);
        ASSERT_TRUE(next);
        Color expected = Color(0.1, 0.3, 0.2) / 0.3;
        if (next->sample.transmits())
            expected = Color(0.7, 0.4, 0.5) / 0.7 / (mode == TransportMode::Radiance ? 2.25 : 1);
        test::expectColor(next->weight, expected, "Is the lobe's probability divided by? In which mode?");
        refractions += next->sample.transmits() ? 1 : 0;
    }
    EXPECT_NEAR(refractions, 0.7 * n, 5.5 * std::sqrt(0.21 * n)) << "Does the lobe have a number of its own?";
}

// Writes down what a walk tells, and ends it at a vertex of one's choice.
class Diary {
public:
    struct Entry {
        Vec3 point;
        Color beta;
        int length;
    };

    explicit Diary(std::size_t last = 1000) : last_(last) {}

    bool reached(const Interaction& at, const WalkState& path) {
        EXPECT_EQ(vertices.size(), directions.size()) << "Is the visitor told how each vertex is left?";
        vertices.push_back({at.point(), path.beta, path.length});
        return vertices.size() < last_;
    }
    void scattered(const Interaction& at, const BsdfSample& sample) {
        EXPECT_EQ(vertices.size(), directions.size() + 1) << "Is a vertex told of before it is left?";
        EXPECT_LE((at.point() - vertices.back().point).norm(), 0) << "At which vertex is the path scattered?";
        directions.push_back(sample.wi);
    }
    void escaped(const WalkState& path) {
        escapes.push_back({path.ray.origin, path.beta, path.length});
        way = path.ray.direction;
    }

    std::vector<Entry> vertices;
    std::vector<Vec3> directions;
    std::vector<Entry> escapes;
    Vec3 way = Vec3::Zero();

private:
    std::size_t last_;
};

SceneObject mirrorAt(Real height, bool up, const Color& reflectance) {
    return {std::make_shared<Plane>(Vec3(0, height, 0), up ? Vec3::UnitY() : Vec3(-Vec3::UnitY())),
            std::make_shared<MirrorMaterial>(reflectance),
            {},
            nullptr};
}

// Back and forth between two coloured mirrors, 2 apart, in tinted air. Each segment is 2.5 long, the first half of it.
TEST(Walk, TellsOfEachVertexInTurn) {
    const Color below(0.9, 0.6, 0.8);
    const Color above(0.7, 0.95, 0.5);
    const Color tint(0.02, 0.1, 0.05);
    const Scene scene =
        of({mirrorAt(0, true, below), mirrorAt(2, false, above), test::tintedAir({-99, -9, -9}, {99, 9, 9}, tint)});
    const Vec3 start(-3, 1, 2);
    const Ray ray = {start, {0.6, -0.8, 0}};
    const Color carried(2, 0.3, 1);
    for (const int most : {1, 2, 7}) {
        Diary diary;
        RayCounts counts;
        walk(scene, {ray, scene.mediaAt(start), carried}, TransportMode::Radiance,
             {.maxLength = most, .rouletteStart = 99}, test::independent.start(0, {0, 0}, 0), counts, diary);
        ASSERT_EQ(diary.vertices.size(), static_cast<std::size_t>(most)) << "After how many segments does a walk end?";
        ASSERT_EQ(diary.directions.size() + 1, diary.vertices.size()) << "Is the last vertex left as well?";
        EXPECT_TRUE(diary.escapes.empty());
        EXPECT_EQ(counts.rays, most) << "Where are the rays counted?";
        Color beta = carried;
        for (int i = 0; i < most; ++i) {
            const auto& [point, found, length] = diary.vertices[static_cast<std::size_t>(i)];
            EXPECT_EQ(length, i + 1) << "How many segments lead to vertex " << i << "?";
            EXPECT_LE((point - Vec3(-2.25 + 1.5 * i, i % 2 == 0 ? 0 : 2, 2)).norm(), 1e-9)
                << "Where is vertex " << i << "?";
            beta *= (-tint * (i == 0 ? 1.25 : 2.5)).exp();
            test::expectColor(found, beta, "What do the media on the way to a vertex let pass?");
            beta *= i % 2 == 0 ? below : above;
        }
    }
}

// By the visitor's word, at what doesn't scatter, in the open, and where nothing is left to carry.
TEST(Walk, EndsWhereThePathDoes) {
    const Scene mirrors = of({mirrorAt(0, true, Color(0.2, 0.1, 0.15)), mirrorAt(2, false, Color(0.2, 0.1, 0.15))});
    const Ray ray = {{0, 1, 0}, {0.6, -0.8, 0}};
    const auto walked = [](const Scene& scene, const Ray& from, TransportMode mode, int rouletteStart, int index,
                           Diary diary) {
        RayCounts counts;
        walk(scene, {from, scene.mediaAt(from.origin), Color(0.5, 0.7, 0.2)}, mode,
             {.maxLength = 10, .rouletteStart = rouletteStart}, test::independent.start(0, {0, 0}, index), counts,
             diary);
        return diary;
    };
    const Diary stopped = walked(mirrors, ray, TransportMode::Radiance, 99, 0, Diary(3));
    EXPECT_EQ(stopped.vertices.size(), 3U) << "What does it mean that reached() says false?";
    EXPECT_EQ(stopped.directions.size(), 2U) << "Does the path go on from there?";

    const Scene black = of({{std::make_shared<Rectangle>(Vec3(-9, 0, 9), Vec3(18, 0, 0), Vec3(0, 0, -18)),
                             nullptr,
                             {},
                             std::make_shared<ConstantTexture>(Color(5, 6, 7))}});
    const Diary absorbed = walked(black, ray, TransportMode::Radiance, 99, 0, Diary());
    EXPECT_EQ(absorbed.vertices.size(), 1U) << "Is the visitor told of a surface that doesn't scatter?";
    EXPECT_TRUE(absorbed.directions.empty() && absorbed.escapes.empty())
        << "How would a path go on from a lamp that scatters nothing?";

    const Diary open = walked(of({}), ray, TransportMode::Radiance, 99, 0, Diary());
    EXPECT_TRUE(open.vertices.empty());
    ASSERT_EQ(open.escapes.size(), 1U) << "Is the visitor told of a path that meets nothing?";
    test::expectColor(open.escapes[0].beta, Color(0.5, 0.7, 0.2), "What does it carry?");

    const Scene plain = of({floor(test::diffuse(test::rho))});
    for (int i = 0; i < 50; ++i) {
        const Diary once = walked(plain, {{3, 4, -5}, {0.6, -0.8, 0}}, TransportMode::Importance, 99, i, Diary());
        ASSERT_EQ(once.vertices.size(), 1U);
        ASSERT_EQ(once.escapes.size(), 1U) << "Is the visitor told of a path that leaves, and once?";
        test::expectColor(once.escapes[0].beta, Color(0.5, 0.7, 0.2) * test::rho, "What does it carry?");
        EXPECT_LE((once.way - once.directions[0]).norm(), 0) << "Along which ray does it leave?";
        EXPECT_LE((once.escapes[0].point - once.vertices[0].point).norm(), 1e-9) << "From where does it leave?";
    }

    const Scene dark = of({mirrorAt(0, true, Color::Zero())});
    const Diary swallowed = walked(dark, ray, TransportMode::Radiance, 0, 0, Diary());
    EXPECT_EQ(swallowed.vertices.size(), 1U);
    EXPECT_TRUE(swallowed.directions.empty() && swallowed.escapes.empty())
        << "What does leaveVertex say of such a path?";
}

// Into glass: radiance is divided by η², importance isn't. And in fog each vertex has its own numbers, none twice.
TEST(Walk, HandsOnModeAndNumbers) {
    SceneObject glass = floor(std::make_shared<RefractionMaterial>(Color::Zero(), Color(0.7, 0.4, 0.5)));
    glass.interior = Interior{1.5, nullptr, 0};
    const Scene into = of({glass});
    for (const TransportMode mode : {TransportMode::Radiance, TransportMode::Importance}) {
        Diary diary;
        RayCounts counts;
        walk(into, {{{3, 4, -5}, {0.6, -0.8, 0}}, into.mediaAt({3, 4, -5}), Color::Ones()}, mode, {.rouletteStart = 99},
             test::independent.start(0, {0, 0}, 0), counts, diary);
        ASSERT_EQ(diary.escapes.size(), 1U);
        test::expectColor(diary.escapes[0].beta, Color(0.7, 0.4, 0.5) / (mode == TransportMode::Radiance ? 2.25 : 1),
                          "What does the path carry, radiance or importance?");
    }
    const auto fog = std::make_shared<test::ColouredFog>(Color(0.1, 0.2, 0.05), Color(3, 2, 4));
    SceneObject cloud;
    cloud.shape = std::make_shared<Box>(Vec3::Constant(-50), Vec3::Constant(50));
    cloud.interior = Interior{1, fog, 0};
    const Scene scene = of({cloud});
    const test::RecordingSampler sampler;
    for (int i = 0; i < 50; ++i) {
        sampler.forget();
        Diary diary;
        RayCounts counts;
        walk(scene, {{Vec3::Zero(), {0, 0.6, 0.8}}, scene.mediaAt(Vec3::Zero()), Color::Ones()},
             TransportMode::Radiance, {.maxLength = 6, .rouletteStart = 99}, sampler.start(0, {0, 0}, i), counts,
             diary);
        ASSERT_EQ(diary.vertices.size(), 6U);
        std::multiset<int> asked;
        for (const auto& one : sampler.asked()) asked.insert(one.dimension);
        for (int vertex = 0; vertex < 6; ++vertex) {
            ASSERT_EQ(asked.count(Dimension::vertex(vertex, VertexUse::Distance).index), 1U)
                << "Which vertex's number says how far light goes? They count from 0.";
        }
    }
}

}  // namespace
}  // namespace caustic
