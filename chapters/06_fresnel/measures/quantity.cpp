#include <cmath>
#include <memory>
#include <numbers>
#include <string>

#include "camera/box_filter.h"
#include "core/text.h"
#include "figure/quantities.h"
#include "figures.h"
#include "furnace.h"
#include "integrator/ray_tracer.h"
#include "material/conductor_material.h"
#include "material/dielectric_material.h"
#include "material/fresnel.h"
#include "material/rough_conductor_bsdf.h"
#include "material/rough_dielectric_bsdf.h"
#include "reference.h"
#include "sampling/independent_sampler.h"
#include "scenes.h"

namespace caustic {

namespace {

constexpr Real degrees = 180 / std::numbers::pi;

// The smallest angle at which nothing comes out of glass any more, by halving.
Real criticalAngle(Real ior) {
    Real low = 0;
    Real high = std::numbers::pi / 2;
    for (int i = 0; i < 60; ++i) {
        const Real middle = (low + high) / 2;
        (fresnelDielectric(std::cos(middle), 1 / ior) < 1 ? low : high) = middle;
    }
    return high;
}

void addAngles(CsvTable& table) {
    for (const Real ior : {1.33, 1.5, 2.4}) {
        table.addRow("Fresnel's equations", "critical angle, index " + formatReal(ior), criticalAngle(ior) * degrees,
                     "degrees", formatReal(std::asin(1 / ior) * degrees) + " = asin(1/n)");
        const Real across = (ior * ior - 1) / (ior * ior + 1);
        table.addRow("Fresnel's equations", "reflectance at Brewster's angle, index " + formatReal(ior),
                     fresnelDielectric(1 / std::hypot(1, ior), ior), "share",
                     formatReal(across * across / 2) + " = ((n^2 - 1)/(n^2 + 1))^2 / 2");
    }
}

void addPanes(CsvTable& table) {
    const IndependentSampler sampler(1);
    const BoxFilter filter;
    for (const Real ior : {1.33, 1.5, 2.4}) {
        const Scene pane(paneScene(std::make_shared<DielectricMaterial>(), ior));
        const RayTracer tracer(pane, sampler, filter, {.maxDepth = 1000, .leastWeight = 1e-9});
        RayCounts counts;
        const Real through = tracer.Li({Vec3(-1, 0, 0), Vec3::UnitX()}, {}, sampler.start(0, {0, 0}, 0), counts).x();
        const Real r = fresnelDielectric(1, ior);
        table.addRow("ray tracing", "pane of index " + formatReal(ior) + ": light let through", through, "share",
                     formatReal((1 - r) / (1 + r)) + " = (1 - R)/(1 + R)");
    }
}

void addSchlick(CsvTable& table) {
    for (const Real ior : {1.1, 1.33, 1.5, 1.8, 2.4, 4.0}) {
        Real largest = 0;
        for (int i = 0; i <= 100'000; ++i) {
            const Real cosO = i / 1e5;
            largest = std::max(largest, std::abs(schlick(cosO, ior) - fresnelDielectric(cosO, ior)));
        }
        table.addRow("Schlick", "largest error, index " + formatReal(ior), 100 * largest, "percent of the light",
                     "Fresnel's equations");
    }
}

// What a metal's colour at normal incidence tells of the other angles, by Schlick.
void addSchlickOfMetals(CsvTable& table) {
    const std::pair<const char*, Metal> metals[] = {
        {"gold", Metal::gold()}, {"silver", Metal::silver()}, {"copper", Metal::copper()}};
    for (const auto& [name, metal] : metals) {
        const Color r0 = fresnelConductor(1, metal.eta, metal.k);
        Color largest = Color::Zero();
        for (int i = 0; i <= 10'000; ++i) {
            const Real cosO = i / 1e4;
            largest = largest.max((schlick(cosO, r0) - fresnelConductor(cosO, metal.eta, metal.k)).abs());
        }
        table.addRow("Schlick", std::string("largest error of three channels, ") + name, 100 * largest.maxCoeff(),
                     "percent of the light", "Fresnel's equations");
    }
}

// The mean weight over an even grid of samples: what comes back of one reflection or refraction, in energy.
Real givenBack(const Bsdf& bsdf, Real cosO) {
    constexpr int perAxis = 256;
    constexpr int perLobe = 64;
    const Vec3 wo(std::sqrt(1 - cosO * cosO), 0, cosO);
    Real sum = 0;
    for (int i = 0; i < perAxis * perAxis; ++i) {
        const Vec2 u((i % perAxis + 0.5) / perAxis, (i / perAxis + 0.5) / perAxis);
        const Real uLobe = (i * 37 % perLobe + 0.5) / perLobe;
        const auto sample = bsdf.sample(wo, u, uLobe, TransportMode::Importance);
        if (sample) sum += sample->f.y() * bsdf.cosine(sample->wi) / sample->pdfW;
    }
    return sum / (perAxis * perAxis);
}

// What a second facet would have got: lost, in this model.
void addLosses(CsvTable& table) {
    const Metal perfect = {Color::Constant(1e-6), Color::Constant(1e6)};
    ShadingFrame glassBelow;
    glassBelow.iorBelow = 1.5;
    for (const Real alpha : {0.1, 0.3, 0.6, 1.0}) {
        const RoughConductorBsdf metal({}, perfect, Ggx(alpha, alpha));
        const RoughDielectricBsdf glass(glassBelow, Ggx(alpha, alpha));
        for (const Real cosO : {0.9, 0.3}) {
            const std::string where = ", roughness " + formatReal(alpha) + ", cosine " + formatReal(cosO);
            table.addRow("rough metal", "light lost to second facets" + where, 100 * (1 - givenBack(metal, cosO)),
                         "percent", "0 for a mirror of reflectance 1");
            table.addRow("rough glass", "light lost to second facets" + where, 100 * (1 - givenBack(glass, cosO)),
                         "percent", "0 for smooth glass");
        }
    }
}

// How far from the mirror's and smooth glass's answer, as facets flatten.
void addLimits(CsvTable& table) {
    const Metal gold = Metal::gold();
    constexpr Real cosO = 0.5;
    BsdfBuffer polished;
    ConductorMaterial(gold).build({}, {}, polished);
    const Vec3 wo(std::sqrt(1 - cosO * cosO), 0, cosO);
    const Real mirror = polished.get()->deltaLobes(wo, TransportMode::Importance).lobe[0].f.y();
    ShadingFrame glassBelow;
    glassBelow.iorBelow = 1.5;
    for (const Real alpha : {1e-1, 1e-2, 1e-3, 1e-4}) {
        const RoughConductorBsdf metal({}, gold, Ggx(alpha, alpha));
        const RoughDielectricBsdf glass(glassBelow, Ggx(alpha, alpha));
        table.addRow("rough gold", "distance from the mirror's reflectance, roughness " + formatReal(alpha),
                     std::abs(givenBack(metal, cosO) - mirror), "share", formatReal(mirror) + ", the mirror's");
        table.addRow("rough glass", "distance from smooth glass, roughness " + formatReal(alpha),
                     std::abs(givenBack(glass, cosO) - 1), "share", "1, smooth glass");
    }
}

void addVariances(CsvTable& table, std::uint64_t seed) {
    for (const Real alpha : {0.1, 0.5, 1.0}) {
        for (const Real cosO : {0.9, 0.3, 0.1}) {
            const Furnace furnace(Metal::gold(), alpha, alpha, cosO);
            const Real truth = referenceAlbedo(cosO, Metal::gold().eta.y(), Metal::gold().k.y(), alpha);
            Real squares[2] = {0, 0};
            for (std::uint64_t round = 0; round < 20'000; ++round) {
                const Real visible = furnace.estimate(DirectionChoice::VisibleNormals, 1, seed, round) - truth;
                const Real all = furnace.estimate(DirectionChoice::AllNormals, 1, seed, round) - truth;
                squares[0] += visible * visible;
                squares[1] += all * all;
            }
            table.addRow("all normals", "variance, roughness " + formatReal(alpha) + ", cosine " + formatReal(cosO),
                         squares[1] / squares[0], "times that of visible normals", "the same number of samples");
        }
    }
}

}  // namespace

void tabulateQuantities(FigureContext& context) {
    writeQuantities({addAngles, addPanes, addSchlick, addSchlickOfMetals, addLosses, addLimits,
                     [&](CsvTable& table) { addVariances(table, context.seed()); }},
                    context);
}

}  // namespace caustic
