#include "measures/timed_command.h"

#include <cstdio>

#include "camera/box_filter.h"
#include "core/check.h"
#include "core/thread_clock.h"
#include "figure/csv_table.h"
#include "image/image_file.h"
#include "image/picture_error.h"
#include "integrator/lamp_edges.h"
#include "integrator/near_lamps.h"
#include "integrator/render.h"
#include "measures/methods.h"
#include "measures/mirror_caustic.h"
#include "sampling/independent_sampler.h"
#include "sampling/sobol_sampler.h"
#include "scenes.h"

namespace caustic {

namespace {

struct Judged {
    Scene scene;
    SppmSettings settings;
    Image reference;
};

Judged judged(const std::string& name, const std::filesystem::path& sources) {
    const auto reference = [&](const std::string& file) { return loadImage(sources / "assets/references" / file); };
    if (name == "mirror_caustic") {
        constexpr int width = 64;
        return {Scene(mirrorCaustic(width)), mirrorCausticSettings(),
                mirrorCausticReference(reference("caustic_floor.exr"), width)};
    }
    checkArgument(name == "peers_box" || name == "point_box", "--errors", name,
                  "must be peers_box, point_box or mirror_caustic");
    const NamedScene& named = namedScene(name);
    return {Scene(named.make(named.width, named.height, "")), named.settings, reference(name + "_sppm.exr")};
}

}  // namespace

void timeMethods(const std::string& name, double seconds, const std::string& methods, const ChapterInputs& chapter,
                 const ChapterOptions& options) {
    checkPositive(seconds, "--time");
    const Judged what = judged(name, chapter.sourceDir);
    const std::vector<bool> leftOut = pixelsNearLamps(what.scene, 2);
    const IndependentSampler random(options.seed);
    const SobolSampler sobol(options.seed);
    const BoxFilter filter;
    CsvTable table({"method", "passes", "time", "time_unit", "error", "error_unit"});
    for (const Method method : allMethods) {
        if (methods != "all" && !tracesPhotons(method)) continue;
        const Sampler& sampler = tracesPhotons(method) ? static_cast<const Sampler&>(sobol) : random;
        const auto integrator = makeIntegrator(method, what.scene, sampler, filter, what.settings);
        // By rule Point a pixel has one path a pass.
        const bool several = method == Method::Pass || method == Method::PhotonMap;
        const double begin = threadSeconds();
        const std::vector<Pixel> edges =
            several ? lampEdges(what.scene, sampler, what.settings.limits, 1) : std::vector<Pixel>();
        const double before = threadSeconds() - begin;
        std::int64_t next = 1;
        const auto look = [&](const Rendering& soFar) {
            if (soFar.passes < next) return true;
            next *= 2;
            table.addRow(nameOf(method), soFar.passes, before + soFar.seconds, "s",
                         rmse(developed(*integrator, soFar), what.reference, leftOut), "radiance (rms)");
            return true;
        };
        const Rendering all =
            render(*integrator, {.seconds = seconds - before,
                                 .look = look,
                                 .choose = withMorePaths(what.scene.camera(), edges, pathsAtLampEdges)});
        requireFinite(all);
        const Real error = rmse(developed(*integrator, all), what.reference, leftOut);
        table.addRow(nameOf(method), all.passes, before + all.seconds, "s", error, "radiance (rms)");
        std::printf("%-32s %6lld passes in %7.2f s, RMSE %.5f\n", nameOf(method).c_str(),
                    static_cast<long long>(all.passes), before + all.seconds, error);
        std::fflush(stdout);
    }
    table.save(options.out / chapter.name / ("timed_" + name + ".csv"));
}

}  // namespace caustic
