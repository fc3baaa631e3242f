#pragma once

#include <numbers>

#include "medium/phase_function.h"
#include "sampling/warp.h"

namespace caustic::test {

/// Light goes into all directions alike: p = 1/(4π). Source: PBR 11.3.
class IsotropicPhase final : public PhaseFunction {
public:
    Real p(const Vec3&, const Vec3&) const override { return value; }
    PhaseSample sample(const Vec3&, const Vec2& u) const override { return {uniformSphere(u), value, value}; }
    Real pdfW(const Vec3&, const Vec3&) const override { return value; }

private:
    static constexpr Real value = std::numbers::inv_pi / 4;
};

}  // namespace caustic::test
