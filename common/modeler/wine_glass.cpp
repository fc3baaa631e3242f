#include "modeler/wine_glass.h"

#include <algorithm>
#include <cmath>

#include "core/check.h"
#include "curve/profile_file.h"
#include "material/dielectric_material.h"
#include "medium/absorbing_medium.h"
#include "surface/surface_of_revolution.h"

namespace caustic {

namespace {

constexpr Real widen = 1.01;    // the wine's radius by the inner wall's
constexpr Real sinks = 0.3e-3;  // how far its bottom reaches into the glass, m

// Where a curve that rises or falls is at a height.
Real parameterAt(const BezierCurve& curve, Real height) {
    Real low = 0;
    Real high = 1;
    const bool rises = curve.position(1).y() > curve.position(0).y();
    for (int i = 0; i < 60; ++i) {
        const Real middle = (low + high) / 2;
        ((curve.position(middle).y() < height) == rises ? low : high) = middle;
    }
    return (low + high) / 2;
}

BezierCurve mapped(const BezierCurve& curve, Real factor, Real down) {
    std::vector<Vec3> points = curve.controlPoints();
    for (Vec3& point : points) point = {factor * point.x(), point.y() - down, 0};
    return BezierCurve(points);
}

BezierCurve reversed(const BezierCurve& curve) {
    return BezierCurve({curve.controlPoints().rbegin(), curve.controlPoints().rend()});
}

SceneObject bodyOfGlass(std::vector<BezierCurve> outline, const Interior& interior) {
    return {std::make_shared<SurfaceOfRevolution>(std::move(outline)), std::make_shared<DielectricMaterial>(), interior,
            nullptr};
}

}  // namespace

SceneObject WineGlass::glass() const { return bodyOfGlass(outline.segments(), {glassIor, nullptr, 1}); }

std::vector<SceneObject> WineGlass::objects() const {
    const Interior wine = {wineIor, std::make_shared<AbsorbingMedium>(wineSigmaA), 0};
    return {glass(), bodyOfGlass(wineOutline(), wine)};
}

std::vector<BezierCurve> WineGlass::wineOutline() const {
    const std::vector<BezierCurve>& all = outline.segments();
    const auto top = std::max_element(all.begin(), all.end(), [](const BezierCurve& a, const BezierCurve& b) {
        return a.position(1).y() < b.position(1).y();
    });
    const Real bottom = all.back().position(1).y();
    checkArgument(level > bottom && level < top->position(1).y(), "wine's level", formatReal(level),
                  "must be within the bowl");
    // From the bottom up along the inside, as far as the wine reaches.
    std::vector<BezierCurve> wine;
    for (auto segment = all.rbegin();; ++segment) {
        const BezierCurve wall = reversed(*segment);
        const bool last = wall.position(1).y() >= level;
        wine.push_back(mapped(last ? wall.split(parameterAt(wall, level)).first : wall, widen, sinks));
        if (last) break;
    }
    const Vec3 edge = wine.back().position(1);
    wine.push_back(BezierCurve({edge, Vec3(0, edge.y(), 0)}));
    return wine;
}

BezierSpline loadOutline(const std::string& file) {
    constexpr Real metre = 1e-3;
    const BezierSpline drawn = loadProfile(file);
    std::vector<BezierCurve> scaled;
    for (const BezierCurve& curve : drawn.segments()) {
        std::vector<Vec3> points = curve.controlPoints();
        for (Vec3& point : points) point *= metre;
        scaled.push_back(BezierCurve(points));
    }
    return BezierSpline(scaled);
}

}  // namespace caustic
