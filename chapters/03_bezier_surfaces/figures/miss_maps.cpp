#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include "core/progress.h"
#include "curve/profile_file.h"
#include "figures.h"
#include "figures/lit_color.h"
#include "image/color_space.h"
#include "image/drawing.h"
#include "image/ray_view.h"
#include "revolution_reference.h"
#include "surface/newton_revolution.h"
#include "surface/surface_of_revolution.h"

namespace caustic {

namespace {

// A random number generator that belongs to the ray.
Random randomOf(const Ray& ray, std::uint64_t seed) {
    const auto bits = [](Real value) { return static_cast<std::uint64_t>(std::llround(value * 1e12)); };
    return {seed, {bits(ray.direction.x()), bits(ray.direction.y())}};
}

// t of the nearest meeting by brute force, infinite when there is none; nothing when it lies in the band of tangency.
std::optional<Real> nearestOf(const SurfaceOfRevolution& surface, const Ray& ray) {
    const auto meetings = meetingsBySubdivision(surface.profile(), ray);
    if (meetings.empty()) return std::numeric_limits<Real>::infinity();
    if (meetings.front().inBand) return std::nullopt;
    return meetings.front().tLow;
}

}  // namespace

void drawMissMaps(FigureContext& context) {
    constexpr int width = 300;
    constexpr int height = 560;
    constexpr int gap = 12;
    constexpr int top = 74;
    const SurfaceOfRevolution surface(loadProfile(context.asset("assets/profiles/wine_glass.svg").string()));
    const Bounds3 box = surface.bounds();
    const Real size = box.diagonal().norm();
    const RayView view = {box.center() + size * Vec3(0, 0.8, 2.2), box.center(), Vec3::UnitY(), 1.02 * size};
    const std::array<std::string, 5> titles = {"one random start", "4 × 4 starts", "bracketing, 4", "bracketing, 8",
                                               "robust"};
    const std::array<NewtonRevolution, 4> newton = {
        NewtonRevolution(surface.profile(), NewtonStartRule::Random, 1),
        NewtonRevolution(surface.profile(), NewtonStartRule::Grid),
        NewtonRevolution(surface.profile(), NewtonStartRule::Bracketing, 4),
        NewtonRevolution(surface.profile(), NewtonStartRule::Bracketing, 8)};
    const int scale = context.byQuality(4, 1);
    context.progress().expect(static_cast<std::int64_t>(titles.size()));
    Drawing drawing(gap + static_cast<int>(titles.size()) * (width + gap), top + height + gap);
    for (std::size_t column = 0; column < titles.size(); ++column) {
        const bool robust = column == newton.size();
        const Image image = supersampled(
            view, width / scale, height / scale, 1,
            [&](const Ray& ray) -> Color {
                const auto hit = surface.intersect(ray);
                const Color there =
                    hit ? litColor(*hit, -ray.direction, Vec3::UnitY(), Color(0.55, 0.6, 0.65)) : paperColor();
                const std::optional<Real> truth = nearestOf(surface, ray);
                if (!truth) return there;
                const Real none = std::numeric_limits<Real>::infinity();
                Random random = randomOf(ray, context.seed());
                const Real t = robust ? (hit ? hit->t : none) : newton[column].intersect(ray, random).value_or(none);
                if (t == *truth || std::abs(t - *truth) <= 1e-6 * size) return there;
                return srgbDecode(t == none ? Color(0.75, 0.15, 0) : Color(0.9, 0.62, 0));
            },
            context.threads());
        const Vec2 corner(gap + static_cast<Real>(column) * (width + gap), top);
        drawing.image(image, {corner, corner + Vec2(width, height)});
        drawing.text(corner + Vec2(width / 2.0, -44), titles[column],
                     {.size = 20, .horizontal = HorizontalAnchor::Centre});
        context.progress().advance();
    }
    drawing.rectangle(Bounds2(Vec2(gap, top - 28), Vec2(gap + 16, top - 12)), Ink{0xbf, 0x26, 0x00});
    drawing.text({gap + 22.0, top - 14.0}, "nothing found, though there is a surface", {.size = 16});
    drawing.rectangle(Bounds2(Vec2(gap + 400, top - 28), Vec2(gap + 416, top - 12)), Ink{0xe6, 0x9e, 0x00});
    drawing.text({gap + 422.0, top - 14.0}, "a meeting behind the nearest one", {.size = 16});
    drawing.save(context.output("miss_maps.png"));
}

}  // namespace caustic
