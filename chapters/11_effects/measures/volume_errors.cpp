#include "measures/volume_errors.h"

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "camera/box_filter.h"
#include "core/parallel.h"
#include "core/progress.h"
#include "integrator/path_tracer.h"
#include "integrator/render.h"
#include "integrator/volume_sppm.h"
#include "measures/air_light.h"
#include "sampling/sobol_sampler.h"

namespace caustic {

namespace {

constexpr int side = 48;
constexpr PathLimits once = {.maxLength = 2, .rouletteStart = 9};

// The closed form, a mean over each pixel: of many places where the lamp is near.
Image closedForm(const AirLight& light) {
    const auto camera = light.scene(side, side).camera;
    Image image(side, side);
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            const int fromLamp = std::max(std::abs(2 * x + 1 - side), std::abs(2 * y + 1 - side)) / 2;
            const int places = fromLamp < 2 ? 64 : fromLamp < 6 ? 8 : 3;
            Color sum = Color::Zero();
            for (int i = 0; i < places * places; ++i) {
                const Vec2 film(x + (i % places + 0.5) / places, y + (i / places + 0.5) / places);
                sum += light.scatteredOnce(camera->sampleRay(film, {0.5, 0.5}).direction);
            }
            image.set(x, y, sum / (places * places));
        }
    }
    return image;
}

// Share of the radiance, root mean square over pixels and channels.
Real shareOff(const Image& found, const Image& truth) {
    Real squares = 0;
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) squares += (found.at(x, y) / truth.at(x, y) - 1).square().mean();
    }
    return std::sqrt(squares / (side * side));
}

// How a method is set up for so much work, and how many passes that is.
struct Measured {
    std::string name;
    std::string setting;
    std::vector<int> work;
    std::function<Rendering(const Scene&, const Sampler&, const PixelFilter&, int work)> take;
};

Rendering byVolumeSppm(const Scene& scene, const Sampler& sampler, const PixelFilter& filter, MediumDirect direct,
                       int places, int passes) {
    VolumeSppmSettings settings;
    settings.limits = once;
    settings.beamRadius = 0.1;
    settings.photons = direct == MediumDirect::Photons ? 16'384 : 0;
    settings.direct = direct;
    settings.places = places;
    VolumeSppm sppm(scene, sampler, filter, settings);
    return render(sppm, {.passes = passes});
}

std::vector<Measured> methods(FigureContext& context) {
    std::vector<int> passes = {1, 4, 16};
    std::vector<int> steps = {4, 16, 64};
    if (context.quality() == Quality::Report) {
        passes = {1, 4, 16, 64, 256};
        steps = {4, 16, 64, 256, 1024};
    }
    return {{"ray marching", "steps", steps,
             [](const Scene& scene, const Sampler& sampler, const PixelFilter& filter, int work) {
                 return byVolumeSppm(scene, sampler, filter, MediumDirect::Marching, work, 1);
             }},
            {"photons along the ray", "passes", passes,
             [](const Scene& scene, const Sampler& sampler, const PixelFilter& filter, int work) {
                 return byVolumeSppm(scene, sampler, filter, MediumDirect::Photons, 1, work);
             }},
            {"equi-angular in 16 places", "passes", passes,
             [](const Scene& scene, const Sampler& sampler, const PixelFilter& filter, int work) {
                 return byVolumeSppm(scene, sampler, filter, MediumDirect::EquiAngular, 16, work);
             }},
            {"path tracing by free flight", "passes", passes,
             [](const Scene& scene, const Sampler& sampler, const PixelFilter& filter, int work) {
                 PathTracer tracer(scene, sampler, filter, {once, Direct::Mis});
                 return render(tracer, {.passes = work});
             }}};
}

}  // namespace

void addVolumeErrors(CsvTable& table, FigureContext& context) {
    const AirLight light;
    const Image truth = closedForm(light);
    const Scene scene(light.scene(side, side));
    const std::vector<Measured> all = methods(context);
    std::vector<std::vector<std::pair<double, Real>>> rows(all.size());
    parallelFor(static_cast<std::int64_t>(all.size()), context.threads(), [&](std::int64_t item) {
        const Measured& method = all[static_cast<std::size_t>(item)];
        const SobolSampler sampler(context.seed());
        const BoxFilter filter;
        for (const int work : method.work) {
            const Rendering rendering = method.take(scene, sampler, filter, work);
            rows[static_cast<std::size_t>(item)].emplace_back(rendering.seconds,
                                                              shareOff(rendering.film.image(), truth));
        }
    });
    for (std::size_t i = 0; i < all.size(); ++i) {
        for (std::size_t j = 0; j < rows[i].size(); ++j)
            table.addRow("fog: " + all[i].name, all[i].setting + "=" + std::to_string(all[i].work[j]), rows[i][j].first,
                         "s", rows[i][j].second, "share of the radiance (rms)");
    }
}

}  // namespace caustic
