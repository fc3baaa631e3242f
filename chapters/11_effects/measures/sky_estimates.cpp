#include "measures/sky_estimates.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "image/spherical_map.h"
#include "integrator/power_heuristic.h"
#include "math/frame.h"
#include "sampling/warp.h"

namespace caustic {

namespace {

using std::numbers::pi;

Vec2 pairOf(Random& random) {
    const Real x = random.uniform();
    return {x, random.uniform()};
}

Real radiance(const Light& map, const Vec3& wi) { return map.Le(Ray{Vec3::Zero(), wi}).y(); }

// Radiance times cosine.
Real arriving(const Light& map, const Vec3& normal, const Vec3& wi) {
    return std::max(Real(0), wi.dot(normal)) * radiance(map, wi);
}

Real cosinePdf(const Vec3& normal, const Vec3& wi) { return std::max(Real(0), wi.dot(normal)) / pi; }

}  // namespace

std::string nameOf(SkyChoice choice) {
    switch (choice) {
        case SkyChoice::Even:
            return "sky: even directions";
        case SkyChoice::Cosine:
            return "sky: by the surface's cosine";
        case SkyChoice::Brightness:
            return "sky: by brightness";
        case SkyChoice::Both:
            break;
    }
    return "sky: both weighed";
}

Real irradiance(const Light& map, const Vec3& normal, SkyChoice choice, int samples, Random& random) {
    const Frame frame = Frame::around(normal);
    Real sum = 0;
    if (choice == SkyChoice::Even) {
        for (int i = 0; i < samples; ++i) sum += arriving(map, normal, uniformSphere(pairOf(random))) * 4 * pi;
        return sum / samples;
    }
    const bool both = choice == SkyChoice::Both;
    const int each = both ? std::max(1, samples / 2) : samples;
    for (int i = 0; i < each; ++i) {
        if (choice != SkyChoice::Brightness) {
            const Vec3 wi = frame.toWorld(cosineHemisphere(pairOf(random)));
            const Real pdf = cosinePdf(normal, wi);
            // Veach 1997, eq. 9.13 with β = 2.
            const Real weight = both ? powerHeuristic(pdf, map.pdfW(Vec3::Zero(), wi)) : 1;
            if (pdf > 0) sum += weight * arriving(map, normal, wi) / pdf;
        }
        if (choice != SkyChoice::Cosine) {
            const auto sample = map.sampleDirect({}, pairOf(random));
            const Real cosine = std::max(Real(0), sample->wi.dot(normal));
            // Veach 1997, eq. 9.13 with β = 2.
            const Real weight = both ? powerHeuristic(sample->pdfW, cosinePdf(normal, sample->wi)) : 1;
            sum += weight * cosine * sample->radiance.y() / sample->pdfW;
        }
    }
    return sum / each;
}

Real referenceIrradiance(const Light& map, const Vec3& normal, int mapHeight) {
    const int rows = 8 * mapHeight;
    const int columns = 2 * rows;
    Real sum = 0;
    for (int y = 0; y < rows; ++y) {
        const Real top = std::cos(pi * y / rows);
        const Real share = (top - std::cos(pi * (y + 1) / rows)) * 2 * pi / columns;
        for (int x = 0; x < columns; ++x)
            sum += share * arriving(map, normal, uvToSpherical({(x + 0.5) / columns, (y + 0.5) / rows}));
    }
    return sum;
}

}  // namespace caustic
