#include "material/bsdf.h"

#include <cmath>

namespace caustic {

Color Bsdf::f(const Vec3& wo, const Vec3& wi, TransportMode mode) const {
    // Importance is scattered as radiance is, with the two directions swapped.
    if (mode == TransportMode::Importance) return f(wi, wo, TransportMode::Radiance) * normalsFactor(wo, wi);
    const Real side = shading_.side(wo);
    const Vec3 in = shading_.toLocal(wi, side);
    const bool transmits = shading_.side(wi) != side;
    if ((in.z() < 0) != transmits) return Color::Zero();
    const Real eta = shading_.eta(side);
    const Color energy = localF(shading_.toLocal(wo, side), in, eta);
    // Veach 1997, 5.2: radiance is denser where the index is larger.
    return transmits ? Color(energy / (eta * eta)) : energy;
}

std::optional<BsdfSample> Bsdf::sample(const Vec3& wo, const Vec2& u, Real uLobe, TransportMode mode) const {
    const Real side = shading_.side(wo);
    const auto local = localSample(shading_.toLocal(wo, side), u, uLobe, shading_.eta(side));
    if (!local || !(local->pdfW > 0)) return std::nullopt;
    return local->delta() ? deltaToWorld(*local, wo, mode) : nonSpecularToWorld(*local, wo, mode);
}

Real Bsdf::pdfW(const Vec3& wo, const Vec3& wi) const {
    const Real side = shading_.side(wo);
    const Vec3 in = shading_.toLocal(wi, side);
    const bool turned = (in.z() < 0) != (shading_.side(wi) != side);
    return localPdfW(shading_.toLocal(wo, side), turned ? Vec3(-in) : in, shading_.eta(side));
}

DeltaLobes Bsdf::deltaLobes(const Vec3& wo, TransportMode mode) const {
    const Real side = shading_.side(wo);
    DeltaLobes lobes;
    for (const BsdfSample& local : localDeltaLobes(shading_.toLocal(wo, side), shading_.eta(side))) {
        if (const auto world = deltaToWorld(local, wo, mode)) lobes.add(*world);
    }
    return lobes;
}

std::optional<BsdfSample> Bsdf::deltaToWorld(const BsdfSample& local, const Vec3& wo, TransportMode mode) const {
    const Real side = shading_.side(wo);
    BsdfSample world = local;
    world.wi = shading_.toWorld(local.wi, side);
    const bool crosses = shading_.side(world.wi) != side;
    if (crosses != local.transmits() || (local.wi.z() < 0) != local.transmits()) return std::nullopt;
    world.eta = crosses ? shading_.eta(side) : 1;
    // Veach 1997, 5.3.2 for importance, 5.2 for radiance.
    world.f *= mode == TransportMode::Importance ? normalsFactor(wo, world.wi) : 1 / (world.eta * world.eta);
    return world;
}

// A direction about which the normals disagree is turned round: so each direction of the right side has a density, and
// paths from lights reach those to which they carry light although paths from the eye bring none from there.
std::optional<BsdfSample> Bsdf::nonSpecularToWorld(const BsdfSample& local, const Vec3& wo, TransportMode mode) const {
    if ((local.wi.z() < 0) != local.transmits()) return std::nullopt;
    const Real side = shading_.side(wo);
    BsdfSample world = local;
    world.wi = shading_.toWorld(local.wi, side);
    const bool turned = (shading_.side(world.wi) != side) != local.transmits();
    if (turned) world.wi = -world.wi;
    world.eta = local.transmits() ? shading_.eta(side) : 1;
    if (turned) {
        world.f = f(wo, world.wi, mode);
    } else if (mode == TransportMode::Radiance) {
        // Veach 1997, 5.2.
        world.f /= world.eta * world.eta;
    } else if (shading_.toLocal(wo, side).z() < 0) {
        world.f = Color::Zero();
    } else {
        world.f *= normalsFactor(wo, world.wi);  // models are reciprocal
    }
    return world;
}

// What makes shading normals mean the same for paths from lights as for those from the eye. Source: Veach 1997, 5.3.2.
Real Bsdf::normalsFactor(const Vec3& wo, const Vec3& wi) const {
    const Real above = std::abs(wo.dot(shading_.frame.n) * wi.dot(shading_.ng));
    const Real below = std::abs(wo.dot(shading_.ng) * wi.dot(shading_.frame.n));
    if (above == below) return 1;
    return below > 0 ? above / below : 0;
}

}  // namespace caustic
