#include "measures/lens_estimates.h"

#include <cmath>

namespace caustic {

ThinLensCamera measuringCamera() { return {Vec3::Zero(), Vec3(0, 0, -1), Vec3::UnitY(), 0.5, 400, 400, 0.1, 4}; }

Real measuredBlur(const ThinLensCamera& camera, Real depth, int side, bool stratified, Random& random) {
    const Vec3 point(0.1 * depth, -0.05 * depth, -depth);
    Vec2 sum = Vec2::Zero();
    Real squares = 0;
    for (int i = 0; i < side * side; ++i) {
        const Real x = random.uniform();
        Vec2 lens(x, random.uniform());
        if (stratified) lens = (Vec2(i % side, i / side) + lens) / side;
        const Vec2 film = camera.sampleImportance(point, lens)->film;
        sum += film;
        squares += film.squaredNorm();
    }
    const Real count = Real(side) * side;
    // Of n points the mean square about their own mean is by 1/n too small.
    const Real variance = (squares / count - (sum / count).squaredNorm()) / 2 * count / (count - 1);
    return 4 * std::sqrt(std::max(variance, Real(0)));
}

}  // namespace caustic
