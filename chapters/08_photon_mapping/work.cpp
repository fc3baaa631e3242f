#include "work.h"

#include <algorithm>
#include <fstream>

#include <nlohmann/json.hpp>

#include "camera/box_filter.h"
#include "core/atomic_file.h"
#include "core/check.h"
#include "core/thread_clock.h"
#include "integrator/bidirectional_path_tracer.h"
#include "integrator/path_tracer.h"
#include "integrator/render.h"
#include "modeler/caustic_scene.h"
#include "sampling/independent_sampler.h"

namespace caustic {

namespace {

constexpr const char* place = "chapters/08_photon_mapping/work.json";
constexpr std::int64_t photonsPerSecond = 150'000;  // that photon mapping takes of the time it has

}  // namespace

SceneDescription causticBeforeMirror() {
    return CausticScene{.lampSide = 0.2}.beforeMirror(CausticWork::width, CausticWork::height);
}

PhotonMapperSettings causticSettings(std::int64_t photons) {
    PhotonMapperSettings settings = {.photons = photons, .limits = {CausticWork::segments, 1}};
    settings.density = {.nearest = 100, .radius = 0.3};
    settings.caustics = {.nearest = 60, .radius = 0.1};
    return settings;
}

CausticWork causticWork(const ChapterInputs& chapter, Quality quality) {
    std::ifstream file(chapter.sourceDir / place);
    checkArgument(file.good(), place, "", "is missing; run --recalibrate SECONDS");
    CausticWork work;
    try {
        const nlohmann::json json = nlohmann::json::parse(file);
        work = {json.at("path tracing"), json.at("bidirectional"), json.at("photon mapping"), json.at("photons")};
    } catch (const nlohmann::json::exception& error) {
        throw InputError({place, 0}, "", std::string("isn't what --recalibrate writes: ") + error.what());
    }
    if (quality == Quality::Report) return work;
    for (std::int64_t* const count :
         {&work.pathSamples, &work.bidirectionalSamples, &work.photonSamples, &work.photons})
        *count = std::max<std::int64_t>(1, *count / 16);
    return work;
}

void recalibrate(double seconds, const ChapterInputs& chapter) {
    const Scene scene(causticBeforeMirror());
    const IndependentSampler sampler(1);
    const BoxFilter filter;
    const PathLimits limits = {CausticWork::segments, 1};
    nlohmann::ordered_json json;
    json["seconds"] = seconds;
    PathTracer paths(scene, sampler, filter, {limits, Direct::Mis});
    json["path tracing"] = render(paths, {.seconds = seconds}).passes;
    BidirectionalPathTracer both(scene, sampler, filter, limits);
    json["bidirectional"] = render(both, {.seconds = seconds}).passes;
    const auto photons = static_cast<std::int64_t>(photonsPerSecond * seconds);
    const double start = threadSeconds();
    PhotonMapper mapper(scene, sampler, filter, causticSettings(photons), 1);
    json["photon mapping"] = render(mapper, {.seconds = std::max(1e-3, seconds - (threadSeconds() - start))}).passes;
    json["photons"] = photons;
    writeTextAtomically(chapter.sourceDir / place, json.dump(2) + "\n");
}

}  // namespace caustic
