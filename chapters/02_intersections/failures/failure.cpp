#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "contact_scene.h"
#include "core/progress.h"
#include "core/text.h"
#include "failures/leaks.h"
#include "failures/slab_cases.h"
#include "figure/failures.h"
#include "figures.h"
#include "leaving.h"
#include "math/frame.h"
#include "math/slabs.h"
#include "math/spawn.h"
#include "shape/ball.h"
#include "shape_catalogue.h"
#include "sphere_methods.h"

namespace caustic {

namespace {

constexpr std::array<double, 4> scales = {1e-3, 1, 1e3, 1e6};

using Rows = std::vector<FailureRow>;

void addRow(Rows& rows, const TriedMethod& method, const std::string& name, const FailureCount& count) {
    rows.push_back({method.name, name, count.failures, count.trials, method.robust});
}

void addLeaks(Rows& rows, FigureContext& context) {
    const std::int64_t rays = context.byQuality(200'000, 10'000'000);
    for (const TriangleMethod& method : triangleMethods()) {
        for (const auto& [aim, name] : {std::pair(Aim::Edges, "closed mesh: rays at edges"),
                                        std::pair(Aim::Vertices, "closed mesh: rays at vertices")}) {
            addRow(rows, {method.name, method.robust}, name,
                   countLeaks(method, aim, rays, context.seed(), context.threads()));
            context.progress().advance();
        }
    }
}

void addSlivers(Rows& rows, FigureContext& context) {
    const int rays = context.byQuality(20'000, 200'000);
    for (const TriangleMethod& method : triangleMethods()) {
        addRow(rows, {method.name, method.robust}, "sliver 1e-4 wide and 2 long: self-hits",
               countSliverSelfHits(method, 1e-4, rays, context.seed()));
    }
    context.progress().advance();
}

void addSlabs(Rows& rows, FigureContext& context) {
    const std::vector<SlabCase> cases = slabCases(20, context.seed());
    for (const char* const place : {"outside", "inside", "a face", "an edge", "a corner"}) {
        FailureCount naive;
        FailureCount ours;
        for (const SlabCase& one : cases) {
            if (one.origin != place) continue;
            naive += {meetsNaively(one.box, one.ray) != one.meets ? 1 : 0, 1};
            ours += {slabInterval(one.box, one.ray).empty() == one.meets ? 1 : 0, 1};
        }
        const std::string name = std::string("box: direction of 0s and 1s from ") + place;
        addRow(rows, {"naive slabs"}, name, naive);
        addRow(rows, {"slabs", true}, name, ours);
    }
    context.progress().advance();
}

// Rays that pass the centre at 0.99 or 1.01 radii: a method that says the contrary is wrong.
template <typename Scalar, typename Method>
FailureCount countWrongSilhouettes(const Method& method, double distance, std::uint64_t seed) {
    using Vector = VectorOf<Scalar>;
    FailureCount count;
    for (; count.trials < 20'000; ++count.trials) {
        Random random(seed, {static_cast<std::uint64_t>(count.trials)});
        const Frame frame = Frame::around(randomDirection(random));
        const bool hits = random.below(2) == 0;
        const double angle = 2 * std::numbers::pi * random.uniform();
        const Vec3 aside = (hits ? 0.99 : 1.01) * (std::cos(angle) * frame.s + std::sin(angle) * frame.t);
        const Vector toCenter = (distance * frame.n + aside).cast<Scalar>();
        const Vector direction = frame.n.cast<Scalar>();
        // What is true of the rounded numbers: double is far finer than what float is asked for here, and the library's
        // double is held against 113 bits in the speed-accuracy chart.
        const bool truth =
            !ballInterval<Real, 3>(toCenter.template cast<Real>(), direction.template cast<Real>(), 1.0).empty();
        const bool found = !method(toCenter, direction, Scalar(1)).empty();
        count.failures += found != truth ? 1 : 0;
    }
    return count;
}

void addSpheres(Rows& rows, FigureContext& context) {
    const std::string name = "sphere 10000 radii away: silhouette (float)";
    const std::uint64_t seed = context.seed();
    addRow(rows, {"textbook quadratic"}, name, countWrongSilhouettes<float>(textbookQuadratic<float>, 1e4, seed));
    addRow(rows, {"projection by Pythagoras"}, name,
           countWrongSilhouettes<float>(pythagorasProjection<float>, 1e4, seed));
    addRow(rows, {"stable quadratic", true}, name, countWrongSilhouettes<float>(stableQuadratic<float>, 1e4, seed));
    addRow(rows, {"projection", true}, name, countWrongSilhouettes<float>(ballInterval<float, 3>, 1e4, seed));
    context.progress().advance();
}

template <typename Scalar>
void addContactScenes(Rows& rows, const TriedMethod& method, const Offset<Scalar>& offset, FigureContext& context) {
    const int rays = context.byQuality(20'000, 200'000);
    for (const double scale : scales) {
        const ContactFailures count = contactFailures<Scalar>(scale, offset, rays, context.seed());
        addRow(rows, method, "ball over a floor: self-hits at scale " + formatReal(scale), count.selfHits);
        addRow(rows, method, "ball over a floor: lost contacts at scale " + formatReal(scale), count.lostContacts);
    }
    context.progress().advance();
}

void addCatalogue(Rows& rows, const TriedMethod& method, const LeavingRule& rule, FigureContext& context) {
    const int rays = context.byQuality(1'000, 10'000);
    for (const double scale : scales) {
        const Transform place =
            Transform::scaling(Vec3::Constant(scale)) * Transform::translation(Vec3(0.3, -0.7, 0.5));
        FailureCount selfHits;
        for (const CatalogueShape& entry : shapeCatalogue(place)) {
            if (!entry.closed && !entry.convex) continue;  // a group: nobody knows what it may be met from
            selfHits += countSelfHits(*entry.shape, entry.closed, entry.convex, rule, place.point(Vec3::Zero()),
                                      1.5 * scale, rays, context.seed());
        }
        addRow(rows, method, "every shape: self-hits at scale " + formatReal(scale), selfHits);
        addRow(rows, method, "every shape: lost contacts at scale " + formatReal(scale),
               countLostContacts(place, 1.0 / 2000, rule, 2 * rays, context.seed()));
        addRow(rows, method, "plate: lost far sides at scale " + formatReal(scale),
               countLostFarSides(place, 1.0 / 2000, rule, 2 * rays, context.seed()));
    }
    context.progress().advance();
}

// A normal is right when it is perpendicular to what two tangents become.
FailureCount countWrongNormals(bool likeDirections, std::uint64_t seed) {
    FailureCount count;
    for (; count.trials < 10'000; ++count.trials) {
        Random random(seed, {static_cast<std::uint64_t>(count.trials)});
        const Transform transform = unevenTransform(random.below(2) == 0);
        const Frame frame = Frame::around(randomDirection(random));
        const Vec3 normal = likeDirections ? transform.vector(frame.n).normalized() : transform.normal(frame.n);
        const Real slant = std::max(std::abs(normal.dot(transform.vector(frame.s).normalized())),
                                    std::abs(normal.dot(transform.vector(frame.t).normalized())));
        count.failures += slant > 1e-12 ? 1 : 0;
    }
    return count;
}

}  // namespace

void chartFailures(FigureContext& context) {
    context.progress().expect(18);
    Rows rows;
    addLeaks(rows, context);
    addSlivers(rows, context);
    addSlabs(rows, context);
    addSpheres(rows, context);
    addContactScenes<float>(rows, {"fixed 1e-4 (float)"}, {1e-4F, 0}, context);
    addContactScenes<double>(rows, {"fixed 1e-4"}, {1e-4, 0}, context);
    addContactScenes<double>(rows, {"fixed 1e-10"}, {1e-10, 0}, context);
    addContactScenes<double>(rows, {"relative", true}, {0, surfaceOffset}, context);
    addCatalogue(rows, {"fixed 1e-4"}, fixedRule(1e-4), context);
    addCatalogue(rows, {"relative", true}, relativeRule(), context);
    addRow(rows, {"like directions"}, "uneven instance: normals", countWrongNormals(true, context.seed()));
    addRow(rows, {"inverse transpose", true}, "uneven instance: normals", countWrongNormals(false, context.seed()));
    context.progress().advance();
    drawFailureMarks(rows, context);
}

}  // namespace caustic
