#include "measures/blurred_edge.h"

#include <cmath>
#include <numbers>
#include <vector>

#include "core/random.h"
#include "integrator/photon_map.h"
#include "modeler/objects.h"
#include "scene/scene.h"

namespace caustic {

namespace {

// Where a falling function has a value, by halving.
template <typename Function>
Real placeOf(const Function& function, Real value, Real low, Real high) {
    for (int i = 0; i < 60; ++i) {
        const Real middle = (low + high) / 2;
        (function(middle) > value ? low : high) = middle;
    }
    return low;
}

}  // namespace

Real blurredEdgeWidth(Real radius) {
    const auto share = [](Real x) { return Real(0.5) - (x * std::sqrt(1 - x * x) + std::asin(x)) / std::numbers::pi; };
    return radius * (placeOf(share, 0.1, -1, 1) - placeOf(share, 0.9, -1, 1));
}

Real blurredEdgeWidth(Real radius, std::int64_t photons, std::uint64_t seed) {
    const Scene scene(
        {{diffuseRectangle({-9, -9, 0}, {18, 0, 0}, {0, 18, 0}, Color::Constant(1))}, {}, Color::Zero(), nullptr});
    Random random(seed, {});
    std::vector<Photon> lit;
    const Color power = Color::Constant(1 / static_cast<Real>(photons));
    for (std::int64_t i = 0; i < photons; ++i)
        lit.push_back({Vec3(random.uniform(-1, 0), random.uniform(-0.5, 0.5), 0), Vec3::UnitZ(), power, Vec3::UnitZ(),
                       1, PhotonWay::Caustic});
    const PhotonMap map(lit);
    // The mean along the border, so that the photons' noise doesn't decide.
    const auto seen = [&](Real x) {
        constexpr int places = 64;
        Real sum = 0;
        for (int i = 0; i < places; ++i) {
            MediumStack media;
            Color passed;
            RayCounts counts;
            const Real y = (0.5 - radius) * (2 * (i + Real(0.5)) / places - 1);
            const auto at = scene.follow({Vec3(x, y, 1), -Vec3::UnitZ()}, media, passed, counts);
            sum += map.radiance(*at, {.nearest = {}, .radius = radius}).x() / places;
        }
        return sum * std::numbers::pi;
    };
    return placeOf(seen, 0.1, -radius, radius) - placeOf(seen, 0.9, -radius, radius);
}

}  // namespace caustic
