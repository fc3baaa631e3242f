#include <array>
#include <string>

#include "contact_scene.h"
#include "core/progress.h"
#include "figures.h"
#include "image/drawing.h"
#include "image/ray_view.h"
#include "math/spawn.h"

namespace caustic {

namespace {

constexpr std::array<double, 5> scales = {1e-4, 1e-3, 1, 1e3, 1e6};

// What the rows of the picture differ in.
struct Row {
    std::string name;
    std::string precision;
    bool single;    // float or double
    Real fixed;     // offset
    Real relative;  // offset in magnitudes
};

const std::array<Row, 4> rows = {{{"fixed 1e-4", "float", true, 1e-4, 0},
                                  {"fixed 1e-4", "double", false, 1e-4, 0},
                                  {"fixed 1e-10", "double", false, 1e-10, 0},
                                  {"relative", "double", false, 0, surfaceOffset}}};

// The light that comes back from where the ray hits: none in shadow, which the sun is asked for from there.
template <typename Scalar>
Color shade(const ContactScene<Scalar>& scene, const Offset<Scalar>& offset,
            const typename ContactScene<Scalar>::Vector& origin,
            const typename ContactScene<Scalar>::Vector& direction) {
    using Vector = typename ContactScene<Scalar>::Vector;
    const auto hit = scene.intersect(origin, direction);
    if (!hit) return Color(0.75, 0.85, 0.95);
    const Vector sun = Vector(Scalar(0.55), Scalar(1.1), Scalar(0.75)).normalized();
    const Scalar cosine = hit->normal.dot(sun);
    const Color albedo = hit->onBall ? Color(0.9, 0.55, 0.15) : Color(0.75, 0.75, 0.75);
    if (cosine <= 0) return albedo * 0.12;
    const Vector start = offset.apply(*hit);
    const bool shadow = scene.meetsBall(start, sun) || scene.meetsFloor(start, sun);
    return albedo * (shadow ? 0.12 : 0.12 + 0.88 * static_cast<double>(cosine));
}

template <typename Scalar>
Image renderTile(double scale, const Offset<Scalar>& offset, int side, int samples, int threads) {
    using Vector = typename ContactScene<Scalar>::Vector;
    const ContactScene<Scalar> scene(static_cast<Scalar>(scale));
    const Scalar size = scene.radius();
    const Vector eye = scene.touch() + size * Vector(1, Scalar(2.4), Scalar(6));
    const Vector forward = (scene.touch() + size * Scalar(0.75) * scene.normal() - eye).normalized();
    const Vector right = forward.cross(scene.normal()).normalized();
    const Vector up = right.cross(forward);
    return supersampled(
        side, side, samples,
        [&](const Vec2& place) {
            const Vector direction = forward + static_cast<Scalar>(0.55 * (place.x() - 0.5)) * right -
                                     static_cast<Scalar>(0.55 * (place.y() - 0.5)) * up;
            return shade<Scalar>(scene, offset, eye, direction);
        },
        threads);
}

Image renderTile(const Row& row, double scale, int side, int samples, int threads) {
    if (row.single) {
        const Offset<float> offset = {static_cast<float>(row.fixed), static_cast<float>(row.relative)};
        return renderTile<float>(scale, offset, side, samples, threads);
    }
    return renderTile<double>(scale, {row.fixed, row.relative}, side, samples, threads);
}

}  // namespace

void drawAcne(FigureContext& context) {
    constexpr int tile = 250;
    constexpr int gap = 12;
    constexpr int left = 130;
    constexpr int top = 56;
    const std::array<std::string, 5> titles = {"size 1/10,000", "size 1/1000", "size 1", "size 1000", "size 1,000,000"};
    const int samples = context.byQuality(2, 4);
    Drawing drawing(left + 5 * (tile + gap), top + 4 * (tile + gap));
    context.progress().expect(20);
    for (std::size_t row = 0; row < rows.size(); ++row) {
        const Real y = top + static_cast<Real>(row) * (tile + gap);
        drawing.text({14, y + tile / 2.0 - 12}, rows[row].name, {.size = 19});
        drawing.text({14, y + tile / 2.0 + 14}, rows[row].precision, {.size = 15});
        for (std::size_t column = 0; column < scales.size(); ++column) {
            const Real x = left + static_cast<Real>(column) * (tile + gap);
            if (row == 0)
                drawing.text({x + tile / 2.0, top - 18.0}, titles[column],
                             {.size = 19, .horizontal = HorizontalAnchor::Centre});
            const Image image = renderTile(rows[row], scales[column], tile, samples, context.threads());
            drawing.image(image, {Vec2(x, y), Vec2(x + tile, y + tile)});
            context.progress().advance();
        }
    }
    drawing.save(context.output("acne.png"));
}

}  // namespace caustic
