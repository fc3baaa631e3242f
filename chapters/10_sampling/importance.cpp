#include "importance.h"

#include <numbers>

#include "math/frame.h"
#include "sampling/warp.h"

namespace caustic {

namespace {

constexpr Real pi = std::numbers::pi;

// The surface's normal on the side that the eye sees.
Vec3 seenNormal(const Interaction& at) {
    const Vec3& ns = at.hit().ns;
    return ns.dot(at.wo()) < 0 ? Vec3(-ns) : ns;
}

}  // namespace

std::string nameOf(Importance density) {
    switch (density) {
        case Importance::Uniform:
            return "uniform";
        case Importance::Cosine:
            return "cosine";
        case Importance::Lamp:
            return "lamp";
        case Importance::Both:
            return "both by MIS";
    }
    return "";
}

Color ImportanceTracer::Li(const Ray& ray, const MediumStack& eye, const PathNumbers& numbers,
                           RayCounts& counts) const {
    //! [importance]
    MediumStack media = eye;
    Color passed;
    const auto at = scene().follow(ray, media, passed, counts);
    if (!at) return Color::Zero();
    if (!at->connectible()) return at->Le();
    const auto wi = sample(*at, numbers);
    if (!wi) return Color::Zero();
    MediumStack beyond = at->media(*wi);
    const auto met = scene().follow(at->spawn(*wi), beyond, passed, counts);
    if (!met || met->light() == nullptr) return Color::Zero();
    // Veach 1997, eq. 2.10: one sample of ∫ f Le cos dω over its density.
    return at->f(*wi, TransportMode::Radiance) * at->cosine(*wi) * met->Le() / pdfW(*at, *wi, met->hit());
    //! [importance]
}

std::optional<Vec3> ImportanceTracer::sample(const Interaction& at, const PathNumbers& numbers) const {
    const bool half = numbers.number(Dimension::vertex(0, VertexUse::Lobe)) < 0.5;
    if (density_ == Importance::Lamp || (density_ == Importance::Both && half)) {
        const auto lamp = scene().lights().front()->sampleDirect(
            at.place(), numbers.pair(Dimension::vertex(0, VertexUse::LightPoint)));
        return lamp ? std::optional(lamp->wi) : std::nullopt;
    }
    const Vec2 u = numbers.pair(Dimension::vertex(0, VertexUse::Direction));
    const Vec3 local = density_ == Importance::Uniform ? uniformCone(u, 0) : cosineHemisphere(u);
    return Frame::around(seenNormal(at)).toWorld(local);
}

Real ImportanceTracer::pdfW(const Interaction& at, const Vec3& wi, const Hit& onLamp) const {
    if (density_ == Importance::Uniform) return 1 / (2 * pi);
    const Real cosine = std::max(Real(0), wi.dot(seenNormal(at))) / pi;
    if (density_ == Importance::Cosine) return cosine;
    const Real lamp = scene().lights().front()->pdfW(at.point(), onLamp);
    // Veach 1997, eq. 9.8 with half of the samples each: f/p weighted by p/(p + q), over the chance 1/2.
    return density_ == Importance::Lamp ? lamp : (cosine + lamp) / 2;
}

}  // namespace caustic
