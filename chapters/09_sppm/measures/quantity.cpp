#include <algorithm>
#include <cmath>

#include "figure/quantities.h"
#include "figures.h"

namespace caustic {

namespace {

const ErrorPoint& lastOf(const std::vector<ErrorPoint>& all, Method method) {
    return *std::find_if(all.rbegin(), all.rend(), [&](const ErrorPoint& point) { return point.method == method; });
}

// Both rules after the same number of passes, the largest that both have done.
void addClaims(CsvTable& table, const std::vector<ErrorPoint>& all) {
    const std::int64_t passes = std::min(lastOf(all, Method::Pass).passes, lastOf(all, Method::Point).passes);
    const ErrorPoint* byPass = nullptr;
    const ErrorPoint* byPoint = nullptr;
    for (const ErrorPoint& point : all) {
        if (point.passes != passes) continue;
        if (point.method == Method::Pass) byPass = &point;
        if (point.method == Method::Point) byPoint = &point;
    }
    const std::string after = " after " + std::to_string(passes) + " passes";
    const std::string other = "of " + nameOf(Method::Point) + "; below 1 is better";
    table.addRow(nameOf(Method::Pass), "error in the caustic" + after, byPass->bright / byPoint->bright, "times that",
                 other);
    table.addRow(nameOf(Method::Pass), "error in the dark half" + after, byPass->dark / byPoint->dark, "times that",
                 other);
}

}  // namespace

void tabulateQuantities(ChapterRuns& runs, FigureContext& context) {
    writeQuantities({[&](CsvTable& table) {
                         for (const BiasCurve& curve : runs.bias(context)) {
                             const std::string alpha = curve.alpha < 1 ? ", α = " + formatReal(curve.alpha) : "";
                             table.addRow(curve.method + alpha, "slope of bias", curve.slope,
                                          "of log bias over log passes", formatReal(curve.alpha - 1) + " by theory");
                             table.addRow(curve.method + alpha, "bias of the first pass", curve.bias.front(),
                                          "share of the radiance", formatReal(curve.firstExpected) + " in closed form");
                         }
                     },
                     [&](CsvTable& table) {
                         const std::vector<ErrorPoint>& all = runs.mirrorErrors(context);
                         addClaims(table, all);
                         for (const Method method : allMethods)
                             table.addRow(nameOf(method), "caustic in a mirror: error at the end",
                                          lastOf(all, method).error, "radiance (rms)",
                                          "after " + std::to_string(lastOf(all, method).passes) + " passes");
                     }},
                    context);
}

}  // namespace caustic
