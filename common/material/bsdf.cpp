#include "material/bsdf.h"

#include <cmath>

namespace caustic {

Color Bsdf::f(const Vec3& wo, const Vec3& wi, TransportMode mode) const {
    const Real side = shading_.side(wo);
    const Vec3 in = shading_.toLocal(wi, side);
    const bool transmits = shading_.side(wi) != side;
    if ((in.z() < 0) != transmits) return Color::Zero();
    const Color energy = localF(shading_.toLocal(wo, side), in, shading_.eta(side));
    if ((energy == 0).all()) return energy;
    return energy * modeFactor(wo, wi, mode);
}

std::optional<BsdfSample> Bsdf::sample(const Vec3& wo, const Vec2& u, Real uLobe, TransportMode mode) const {
    const Real side = shading_.side(wo);
    const auto local = localSample(shading_.toLocal(wo, side), u, uLobe, shading_.eta(side));
    if (!local || !(local->pdfW > 0)) return std::nullopt;
    return toWorld(*local, wo, mode);
}

Real Bsdf::pdfW(const Vec3& wo, const Vec3& wi) const {
    const Real side = shading_.side(wo);
    const Vec3 in = shading_.toLocal(wi, side);
    if ((in.z() < 0) != (shading_.side(wi) != side)) return 0;
    return localPdfW(shading_.toLocal(wo, side), in, shading_.eta(side));
}

DeltaLobes Bsdf::deltaLobes(const Vec3& wo, TransportMode mode) const {
    const Real side = shading_.side(wo);
    DeltaLobes lobes;
    for (const BsdfSample& local : localDeltaLobes(shading_.toLocal(wo, side), shading_.eta(side))) {
        if (const auto world = toWorld(local, wo, mode)) lobes.add(*world);
    }
    return lobes;
}

std::optional<BsdfSample> Bsdf::toWorld(const BsdfSample& local, const Vec3& wo, TransportMode mode) const {
    const Real side = shading_.side(wo);
    BsdfSample world = local;
    world.wi = shading_.toWorld(local.wi, side);
    const bool crosses = shading_.side(world.wi) != side;
    if (crosses != local.transmits() || (local.wi.z() < 0) != local.transmits()) return std::nullopt;
    world.eta = crosses ? shading_.eta(side) : 1;
    world.f *= modeFactor(wo, world.wi, mode);
    return world;
}

Real Bsdf::modeFactor(const Vec3& wo, const Vec3& wi, TransportMode mode) const {
    const Real side = shading_.side(wo);
    if (mode == TransportMode::Radiance) {
        if (shading_.side(wi) == side) return 1;
        const Real eta = shading_.eta(side);
        return 1 / (eta * eta);
    }
    const Real above = std::abs(wo.dot(shading_.frame.n) * wi.dot(shading_.ng));
    const Real below = std::abs(wo.dot(shading_.ng) * wi.dot(shading_.frame.n));
    if (above == below) return 1;
    return below > 0 ? above / below : 0;
}

}  // namespace caustic
