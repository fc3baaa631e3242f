#include <cmath>
#include <functional>
#include <limits>
#include <string>

#include "core/csv_table.h"
#include "core/progress.h"
#include "figures.h"
#include "leaving.h"
#include "math/spawn.h"
#include "shape_catalogue.h"

namespace caustic {

namespace {

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

}  // namespace

void tabulateQuantities(FigureContext& context) {
    const std::vector<CatalogueShape> catalogue = shapeCatalogue();
    context.progress().expect(static_cast<std::int64_t>(catalogue.size()));
    CsvTable table({"method", "case", "value", "unit", "reference"});
    constexpr double ours = surfaceOffset / std::numeric_limits<Real>::epsilon();
    for (std::size_t i = 0; i < catalogue.size(); ++i) {
        context.progress().advance();
        if (!catalogue[i].closed && !catalogue[i].convex) continue;  // a group may be hit again, by rights
        const double fewest = fewestEpsilons(i, context.byQuality(1'000, 20'000), context.seed());
        table.addRow("relative", "smallest offset without self-hits: " + catalogue[i].name, fewest,
                     "machine epsilons of the magnitude", "the rule takes " + std::to_string(std::lround(ours)));
    }
    table.save(context.output("quantity.csv"));
}

}  // namespace caustic
