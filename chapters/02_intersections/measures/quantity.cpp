#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <utility>

#include "contact_scene.h"
#include "figure/quantities.h"
#include "figures.h"
#include "leaving.h"
#include "math/spawn.h"
#include "measures/sphere_accuracy.h"
#include "shape_catalogue.h"

namespace caustic {

namespace {

constexpr int raysPerCase = 5000;  // in a draft, too: with other rays "the smallest that works" is another number

// The rule with another number of machine epsilons.
LeavingRule relativeRuleOf(double epsilons) {
    return [epsilons](const Hit& from, const Vec3& direction) {
        const Real distance = epsilons * std::numeric_limits<Real>::epsilon() * from.magnitude;
        const Real side = direction.dot(from.ng) >= 0 ? 1 : -1;
        return Ray{from.point + side * distance * from.ng, direction};
    };
}

// The fewest epsilons, among powers of two, with which no ray hits the shape that it left, at four scales, near the
// coordinates' origin and away from it. Found from above: fewer may work by luck, but nothing larger fails.
double fewestEpsilons(std::size_t entry, std::int64_t rays, std::uint64_t seed) {
    constexpr double ours = surfaceOffset / std::numeric_limits<Real>::epsilon();
    const auto works = [&](double epsilons) {
        for (const double scale : {1e-3, 1.0, 1e3, 1e6}) {
            const Transform larger =
                Transform::scaling(Vec3::Constant(scale)) * Transform::translation({0.3, -0.7, 0.5});
            const Transform farther = Transform::translation(scale * Vec3(0.3, -0.7, 1));
            for (const Transform& place : {larger, farther}) {
                const CatalogueShape one = shapeCatalogue(place)[entry];
                const Real reach = 1.5 * place.linear()(0, 0);
                if (countSelfHits(*one.shape, one.closed, one.convex, relativeRuleOf(epsilons),
                                  place.point(Vec3::Zero()), reach, rays, seed)
                        .failures > 0)
                    return false;
            }
        }
        return true;
    };
    double epsilons = ours;
    while (epsilons >= 1 && works(epsilons / 2)) epsilons /= 2;
    return epsilons;
}

void addFewestEpsilons(CsvTable& table, FigureContext& context) {
    const std::vector<CatalogueShape> catalogue = shapeCatalogue();
    constexpr double ours = surfaceOffset / std::numeric_limits<Real>::epsilon();
    for (std::size_t i = 0; i < catalogue.size(); ++i) {
        if (!catalogue[i].closed && !catalogue[i].convex) continue;  // a group may be hit again, by rights
        const double fewest = fewestEpsilons(i, raysPerCase, context.seed());
        table.addRow("relative", "smallest offset without self-hits: " + catalogue[i].name, fewest,
                     "machine epsilons of the magnitude", "the rule takes " + std::to_string(std::lround(ours)));
    }
}

// The last of start, start · factor, start · factor², ... before the first that doesn't work.
double lastThatWorks(double start, double factor, const std::function<bool(double)>& works) {
    double last = start;
    while (works(last * factor)) last *= factor;
    return last;
}

// How small and how large a scene may be for a fixed distance, and how small and how large the distance for a scene of
// size 1; all to a quarter of a decade.
template <typename Scalar>
void addFixedDistances(CsvTable& table, const std::string& precision, FigureContext& context) {
    const double step = std::pow(10, 0.25);
    const std::string reference =
        "a gap of 1/2000 is kept, and no self-hit in " + std::to_string(raysPerCase) + " rays";
    const auto works = [&](double size, double distance) {
        const ContactFailures count =
            contactFailures<Scalar>(size, {static_cast<Scalar>(distance), 0}, raysPerCase, context.seed());
        return count.selfHits.failures + count.lostContacts.failures == 0;
    };
    for (const auto& [end, factor] : {std::pair("smallest", 1 / step), std::pair("largest", step)}) {
        const double size = lastThatWorks(1, factor, [&](double s) { return works(s, 1e-4); });
        table.addRow("fixed 1e-4, " + precision, std::string("ball over a floor: ") + end + " size that works", size,
                     "radius of the ball", reference);
    }
    for (const auto& [end, factor] : {std::pair("smallest", 1 / step), std::pair("largest", step)}) {
        const double distance = lastThatWorks(1e-4, factor, [&](double d) { return works(1, d); });
        table.addRow("fixed, " + precision, std::string("ball over a floor: ") + end + " distance that works at size 1",
                     distance, "radii of the ball", reference);
    }
}

void addSmallestGap(CsvTable& table, FigureContext& context) {
    const Transform place = Transform::translation(Vec3(0.3, -0.7, 0.5));
    const double gap = lastThatWorks(1.0 / 2000, 0.5, [&](double smaller) {
        return countLostContacts(place, smaller, relativeRule(), raysPerCase, context.seed()).failures == 0;
    });
    table.addRow("relative", "every shape: smallest gap that is kept", gap, "sizes of the shapes",
                 "found by halving 1/2000; the rule's offset is " + formatReal(surfaceOffset));
}

// How many digits of t a decade of distance costs: slope of log error over log distance, least squares.
template <typename Scalar>
void addDigitsLost(CsvTable& table, const std::string& precision, int lastExponent, FigureContext& context) {
    const double middle = (1 + lastExponent) / 2.0;
    for (const auto& method : sphereMethods<Scalar>()) {
        double products = 0;
        double squares = 0;
        for (int exponent = 1; exponent <= lastExponent; ++exponent) {
            const auto cases = sphereCases<Scalar>(std::pow(10, exponent), chartedRays, context.seed());
            const double digits = std::log10(sphereError(method, cases, context.threads()));
            products += (exponent - middle) * digits;
            squares += (exponent - middle) * (exponent - middle);
        }
        table.addRow(method.name + ", " + precision, "sphere 10 to 1e" + std::to_string(lastExponent) + " radii away",
                     products / squares, "digits of t lost per decade of distance", "113-bit");
    }
}

}  // namespace

void tabulateQuantities(FigureContext& context) {
    const auto part = [&context](auto* add) { return [add, &context](CsvTable& table) { add(table, context); }; };
    writeQuantities({// In float the fragile methods lose every hit from 10⁴ radii on: no slope there.
                     [&](CsvTable& table) { addDigitsLost<float>(table, "float", 3, context); },
                     [&](CsvTable& table) { addDigitsLost<double>(table, "double", 7, context); },
                     [&](CsvTable& table) { addFixedDistances<float>(table, "float", context); },
                     [&](CsvTable& table) { addFixedDistances<double>(table, "double", context); },
                     part(addSmallestGap), part(addFewestEpsilons)},
                    context);
}

}  // namespace caustic
