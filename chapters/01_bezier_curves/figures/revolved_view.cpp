#include "figures/revolved_view.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>

namespace caustic {

namespace {

constexpr int piecesPerSegment = 400;

// Where the outline stands at one height.
struct Outline {
    Real radius = 0;
    Real slope = 0;  // of the radius over the height
};

// The outermost crossing of each row with the profile, from the lowest row up.
std::vector<Outline> outlines(const BezierSpline& profile, Real lowest, Real rowHeight, int rows) {
    std::vector<Outline> found(static_cast<std::size_t>(rows));
    const int pieces = piecesPerSegment * static_cast<int>(profile.segments().size());
    Vec3 from = profile.position(0);
    for (int i = 1; i <= pieces; ++i) {
        const Vec3 to = profile.position(Real(i) / piecesPerSegment);
        const auto [low, high] = std::minmax(from.y(), to.y());
        const int first = std::max(0, static_cast<int>(std::ceil((low - lowest) / rowHeight - Real(0.5))));
        for (int row = first; row < rows && lowest + (row + Real(0.5)) * rowHeight <= high; ++row) {
            const Real share = (lowest + (row + Real(0.5)) * rowHeight - from.y()) / (to.y() - from.y());
            const Real radius = from.x() + share * (to.x() - from.x());
            Outline& outline = found[static_cast<std::size_t>(row)];
            if (radius > outline.radius) outline = {radius, (to.x() - from.x()) / (to.y() - from.y())};
        }
        from = to;
    }
    return found;
}

Color shade(const Vec3& normal, const RevolvedLook& look) {
    const Vec3 lamp = Vec3(-0.45, 0.62, 0.64).normalized();
    const Vec3 halfway = (lamp + Vec3::UnitZ()).normalized();
    const Real grazing = std::pow(1 - normal.z(), Real(1.6));
    const Real diffuse = look.transparent ? 1 : Real(0.35) + Real(0.65) * std::max(Real(0), normal.dot(lamp));
    const Real shine = look.highlight * std::pow(std::max(Real(0), normal.dot(halfway)), Real(60));
    return (diffuse * ((1 - grazing) * look.body + grazing * look.edge)).min(1) * (1 - shine) + shine;
}

}  // namespace

Image shadeRevolved(const BezierSpline& profile, const RevolvedLook& look, Real pixelsPerUnit) {
    const Bounds3 box = profile.bounds();
    const int width = std::max(1, static_cast<int>(std::lround(box.max().x() * pixelsPerUnit)));
    const int height = std::max(1, static_cast<int>(std::lround(box.sizes().y() * pixelsPerUnit)));
    const auto rows = outlines(profile, box.min().y(), box.sizes().y() / height, height);
    Image image(width, height, Color::Ones());
    for (int y = 0; y < height; ++y) {
        const auto [radius, slope] = rows[static_cast<std::size_t>(height - 1 - y)];
        for (int x = 0; x < width; ++x) {
            const Real across = (Real(x) + Real(0.5) - width) / pixelsPerUnit / std::max(radius, Real(1e-9));
            if (across < -1) continue;
            image.set(x, y, shade(Vec3(across, -slope, std::sqrt(1 - across * across)).normalized(), look));
        }
    }
    return image;
}

}  // namespace caustic
