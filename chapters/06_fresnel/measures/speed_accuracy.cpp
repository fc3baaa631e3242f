#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/progress.h"
#include "core/random.h"
#include "core/text.h"
#include "figure/csv_table.h"
#include "figure/timing.h"
#include "figures.h"
#include "furnace.h"
#include "material/fresnel.h"
#include "measures/fresnel_table.h"
#include "reference.h"

namespace caustic {

namespace {

// What is measured: an error now, and the same work again for the clock.
struct Measurement {
    std::string method;
    std::string setting;
    Real error;
    std::string unit;
    std::string timeUnit;
    Real divisor;  // from nanoseconds of a piece of work to the time's unit
    std::function<void()> work;
};

std::vector<Real> someCosines(std::uint64_t seed) {
    std::vector<Real> cosines;
    for (std::uint64_t i = 0; i < 4096; ++i) cosines.push_back(1 - Random(seed, {i}).uniform());
    return cosines;
}

void addFormula(std::vector<Measurement>& all, const std::string& method, const std::string& setting, Real ior,
                const std::shared_ptr<const std::vector<Real>>& cosines, const std::function<Real(Real)>& formula,
                const std::function<void()>& work) {
    Real squares = 0;
    for (const Real cosine : *cosines) {
        const Real off = formula(cosine) - referenceDielectric(cosine, ior).mean();
        squares += off * off;
    }
    const Real count = static_cast<Real>(cosines->size());
    all.push_back({method, setting, std::sqrt(squares / count), "reflectance (rms)", "ns", count, work});
}

// The clock is to see the formula inlined as it is in a BSDF, not a call through std::function.
template <typename Formula>
std::function<void()> sumOf(const std::shared_ptr<const std::vector<Real>>& cosines, const Formula& formula) {
    return [cosines, formula] {
        Real sum = 0;
        for (const Real cosine : *cosines) sum += formula(cosine);
        keep(sum);
    };
}

void addFormulas(std::vector<Measurement>& all, FigureContext& context) {
    const auto cosines = std::make_shared<const std::vector<Real>>(someCosines(context.seed()));
    for (const Real ior : {1.1, 1.33, 1.5, 1.8, 2.4, 4.0}) {
        const std::string setting = "ior=" + formatReal(ior);
        const auto exact = [ior](Real cosine) { return fresnelDielectric(cosine, ior); };
        const auto approximate = [ior](Real cosine) { return schlick(cosine, ior); };
        addFormula(all, "Fresnel's equations", setting, ior, cosines, exact, sumOf(cosines, exact));
        addFormula(all, "Schlick", setting, ior, cosines, approximate, sumOf(cosines, approximate));
        context.progress().advance();
    }
    for (const int steps : {4, 8, 16, 32, 64, 128, 256}) {
        const auto table = [table = FresnelTable(1.5, steps)](Real cosine) { return table(cosine); };
        addFormula(all, "table", "steps=" + std::to_string(steps) + ";ior=1.5", 1.5, cosines, table,
                   sumOf(cosines, table));
    }
    context.progress().advance();
}

void addFurnaces(std::vector<Measurement>& all, FigureContext& context) {
    constexpr Real cosO = 0.3;
    const Metal gold = Metal::gold();
    const int rounds = context.byQuality(200, 1000);
    for (const Real alpha : {0.1, 0.5}) {
        const auto furnace = std::make_shared<Furnace>(gold, alpha, alpha, cosO);
        const Real truth = referenceAlbedo(cosO, gold.eta.y(), gold.k.y(), alpha);
        for (const DirectionChoice choice :
             {DirectionChoice::VisibleNormals, DirectionChoice::AllNormals, DirectionChoice::Cosine}) {
            for (const int samples : {4, 16, 64, 256, 1024}) {
                Real squares = 0;
                for (int round = 0; round < rounds; ++round) {
                    const Real off =
                        furnace->estimate(choice, samples, context.seed(), static_cast<std::uint64_t>(round)) - truth;
                    squares += off * off;
                }
                all.push_back({nameOf(choice), "alpha=" + formatReal(alpha) + ";samples=" + std::to_string(samples),
                               std::sqrt(squares / rounds), "reflectance (rms)", "us", 1000,
                               [furnace, choice, samples] { keep(furnace->estimate(choice, samples, 1, 1)); }});
            }
            context.progress().advance();
        }
    }
}

}  // namespace

void chartSpeedAccuracy(FigureContext& context) {
    context.progress().expect(6 + 1 + 6 + 1);
    std::vector<Measurement> all;
    addFormulas(all, context);
    addFurnaces(all, context);
    std::vector<std::function<void()>> pieces;
    for (const Measurement& one : all) pieces.push_back(one.work);
    const auto nanoseconds = medianNanoseconds(pieces, {context.byQuality(5, 15), 1e-3});
    CsvTable table({"method", "setting", "time", "time_unit", "error", "error_unit"});
    for (std::size_t i = 0; i < all.size(); ++i)
        table.addRow(all[i].method, all[i].setting, nanoseconds[i] / all[i].divisor, all[i].timeUnit, all[i].error,
                     all[i].unit);
    table.save(context.output("speed_accuracy.csv"));
    context.chart("measures/speed_accuracy.gp", "speed_accuracy.png");
}

}  // namespace caustic
