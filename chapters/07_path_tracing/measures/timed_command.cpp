#include "measures/timed_command.h"

#include <algorithm>
#include <cstdio>

#include "camera/box_filter.h"
#include "figure/csv_table.h"
#include "image/image_file.h"
#include "image/picture_error.h"
#include "image/tone_mapping.h"
#include "integrator/near_lamps.h"
#include "integrator/render.h"
#include "measures/measured_scenes.h"
#include "measures/work.h"
#include "methods.h"
#include "sampling/independent_sampler.h"

namespace caustic {

namespace {

bool powerOfTwo(std::int64_t n) { return (n & (n - 1)) == 0; }

std::string fileName(const std::string& name) {
    std::string file = name;
    std::replace(file.begin(), file.end(), ' ', '_');
    return file;
}

}  // namespace

void renderTimed(double seconds, const std::string& name, const ChapterInputs& chapter, const ChapterOptions& options) {
    const MeasuredScene& measured = measuredScene(name);
    const int width = measured.width;
    const std::filesystem::path folder = options.out / chapter.name;
    const Scene scene(measured.make(width));
    const Image reference = referenceOf(measured, width, chapter.sourceDir / measured.asset, options.threads);
    const std::vector<bool> leftOut = pixelsNearLamps(scene, 2);
    const IndependentSampler sampler(options.seed);
    const BoxFilter filter;
    CsvTable table({"method", "samples", "time", "time_unit", "error", "error_unit"});
    std::printf("%s, %d x %d pixels; error against %s; pixels within 2 of a lamp left out\n", measured.title.c_str(),
                width, width, measured.judge.c_str());
    for (const Method method : allMethods) {
        const auto integrator = makeIntegrator(method, scene, sampler, filter, measured.mostSegments);
        const auto enter = [&](const Rendering& soFar) {
            const Real error = rmse(soFar.film.image(), reference, leftOut);
            table.addRow(nameOf(method), soFar.passes, soFar.seconds, "s", error, "radiance (rms)");
        };
        const auto look = [&](const Rendering& soFar) {
            if (powerOfTwo(soFar.passes)) enter(soFar);
            return true;
        };
        const Rendering rendering = render(*integrator, {.seconds = seconds, .look = look});
        if (!powerOfTwo(rendering.passes)) enter(rendering);
        const Image picture = rendering.film.image();
        const Real error = rmse(picture, reference, leftOut);
        const double perSecond = static_cast<double>(rendering.passes) * width * width / rendering.seconds;
        std::printf("%-28s %6lld samples a pixel in %7.2f s, %9.0f samples/s, RMSE %.4f, %lld bad\n",
                    nameOf(method).c_str(), static_cast<long long>(rendering.passes), rendering.seconds, perSecond,
                    error, static_cast<long long>(rendering.film.badSamples()));
        std::fflush(stdout);
        saveImage(folder / ("timed_" + name + "_" + fileName(nameOf(method)) + ".png"), toneMapped(picture, 1, 4));
    }
    table.save(folder / ("timed_" + name + ".csv"));
}

}  // namespace caustic
