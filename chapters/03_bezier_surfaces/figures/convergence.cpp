#include "figures/convergence.h"

#include <array>
#include <atomic>
#include <cmath>
#include <string>

#include "core/progress.h"
#include "figure/csv_table.h"
#include "figures.h"
#include "image/color_space.h"
#include "image/drawing.h"
#include "revolution_reference.h"

namespace caustic {

Outcome outcomeOf(const BezierCurve& profile, const RevolvedCurve& curve, const Ray& ray, bool bracketing,
                  const Vec2& start) {
    std::optional<Real> truth;
    for (const ReferenceMeeting& meeting : meetingsBySubdivision({profile}, ray)) {
        if (!truth && meeting.tLow > 0) truth = meeting.tLow;
    }
    NewtonStarts starts;
    if (bracketing) {
        starts = curve.bracketingStarts(ray);
    } else {
        starts.add(startAt(curve, ray, start.x(), start.y()));
    }
    const auto found = nearestByNewton(curve, ray, starts);
    if (!truth) return Outcome::Empty;
    if (!found) return Outcome::Lost;
    return std::abs(found->t - *truth) <= 1e-4 * *truth ? Outcome::Right : Outcome::Farther;
}

namespace {

struct Row {
    std::string name;
    BezierCurve profile;
    RayView view;
    int pieces;  // between which the bracketing start is sought
};

std::array<Row, 2> rows() {
    return {{{"a line segment, turned: a disc",
              BezierCurve({Vec3::Zero(), Vec3(1, 0, 0)}),
              {Vec3(0, 3, 4.2), Vec3::Zero(), Vec3::UnitY(), 2.2},
              1},
             {"a cubic, turned",
              BezierCurve({Vec3(0.35, -1, 0), Vec3(1.5, -0.5, 0), Vec3(-0.3, 0.4, 0), Vec3(0.75, 1, 0)}),
              {Vec3(0, 1.6, 5), Vec3::Zero(), Vec3::UnitY(), 2.7},
              8}}};
}

Color colorOf(Outcome outcome) {
    const auto ink = [](const Ink& of) {
        return srgbDecode(Color(Real(of.red) / 255, Real(of.green) / 255, Real(of.blue) / 255));
    };
    switch (outcome) {
        case Outcome::Right:
            return ink(palette::blue);
        case Outcome::Farther:
            return ink(palette::orange);
        case Outcome::Lost:
            return ink(palette::dark);
        default:
            return paperColor();
    }
}

}  // namespace

void drawConvergence(FigureContext& context) {
    constexpr int tile = 460;
    constexpr int gap = 20;
    constexpr int top = 96;
    constexpr int left = 20;
    Drawing drawing(left + 3 * (tile + gap), top + 2 * (tile + gap + 34));
    context.progress().expect(6);
    CsvTable table({"surface", "start", "pixels", "nearest", "farther", "lost"});
    const std::array<std::string, 3> titles = {"one random start", "another random start", "bracketing starts"};
    const std::array<Vec2, 2> starts = {Vec2(0.5, 0.3), Vec2(0.85, 0.78)};
    const int side = context.byQuality(160, 460);
    Real y = top;
    for (const Row& row : rows()) {
        drawing.text({left, y - 10}, row.name, {.size = 19, .bold = true});
        const RevolvedCurve curve(row.profile, row.pieces);
        for (std::size_t column = 0; column < titles.size(); ++column) {
            const bool bracketing = column == 2;
            std::array<std::atomic<std::int64_t>, 4> counts = {};
            const Image image = supersampled(
                row.view, side, side, 1,
                [&](const Ray& ray) {
                    const Outcome outcome =
                        outcomeOf(row.profile, curve, ray, bracketing, starts[bracketing ? 0 : column]);
                    ++counts[static_cast<std::size_t>(outcome)];
                    return colorOf(outcome);
                },
                context.threads());
            const Vec2 corner(left + static_cast<Real>(column) * (tile + gap), y + 4);
            drawing.image(image, {corner, corner + Vec2(tile, tile)});
            const std::int64_t right = counts[1];
            const std::int64_t farther = counts[2];
            const std::int64_t lost = counts[3];
            table.addRow(row.name, titles[column], right + farther + lost, right, farther, lost);
            const double share = 100.0 * static_cast<double>(right) / static_cast<double>(right + farther + lost);
            drawing.text(corner + Vec2(12, tile - 14), formatReal(std::round(share * 10) / 10) + " % right",
                         {.size = 18});
            context.progress().advance();
        }
        y += tile + gap + 34;
    }
    for (std::size_t column = 0; column < titles.size(); ++column) {
        drawing.text({left + static_cast<Real>(column) * (tile + gap) + tile / 2.0, 28}, titles[column],
                     {.size = 21, .horizontal = HorizontalAnchor::Centre});
    }
    const std::array<std::pair<Ink, std::string>, 3> legend = {{{palette::blue, "converges to the nearest meeting"},
                                                                {palette::orange, "to one behind it"},
                                                                {palette::dark, "gives up"}}};
    Real x = left + 2 * (tile + gap) - 280;
    for (const auto& [ink, text] : legend) {
        drawing.rectangle(Bounds2(Vec2(x, 50), Vec2(x + 16, 66)), ink);
        drawing.text({x + 22, 64}, text, {.size = 16});
        x += 50 + drawing.textWidth(text, {.size = 16});
    }
    table.save(context.output("convergence.csv"));
    drawing.save(context.output("convergence.png"));
}

}  // namespace caustic
