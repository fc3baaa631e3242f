#include "measures/work.h"

#include <algorithm>
#include <fstream>

#include <nlohmann/json.hpp>

#include "camera/box_filter.h"
#include "core/atomic_file.h"
#include "core/check.h"
#include "figures/equal_time.h"
#include "integrator/render.h"
#include "sampling/independent_sampler.h"

namespace caustic {

namespace {

constexpr const char* place = "chapters/07_path_tracing/measures/work.json";

}  // namespace

WorkCounts::WorkCounts(const std::filesystem::path& sources) {
    std::ifstream file(sources / place);
    checkArgument(file.good(), place, "", "is missing; run --recalibrate SECONDS");
    try {
        const nlohmann::json json = nlohmann::json::parse(file);
        seconds_ = json.at("seconds");
        samples_ = json.at("samples");
    } catch (const nlohmann::json::exception& error) {
        throw InputError({place, 0}, "", std::string("isn't what --recalibrate writes: ") + error.what());
    }
}

std::int64_t WorkCounts::samples(const std::string& picture, Method method, Quality quality) const {
    const auto found = samples_.find(picture);
    checkArgument(found != samples_.end() && found->second.contains(nameOf(method)), place,
                  picture + ", " + nameOf(method), "has no such count; run --recalibrate SECONDS");
    const std::int64_t report = found->second.at(nameOf(method));
    return quality == Quality::Report ? report : std::max<std::int64_t>(1, report / 16);
}

void recalibrate(double seconds, const ChapterInputs& chapter) {
    nlohmann::ordered_json json;
    json["seconds"] = seconds;
    for (const EqualTimePicture& picture : equalTimePictures()) {
        const Scene scene(picture.make());
        const IndependentSampler sampler(1);
        const BoxFilter filter;
        for (const Method method : allMethods) {
            const auto integrator = makeIntegrator(method, scene, sampler, filter, picture.mostSegments);
            json["samples"][picture.name][nameOf(method)] = render(*integrator, {.seconds = seconds}).passes;
        }
    }
    writeTextAtomically(chapter.sourceDir / place, json.dump(2) + "\n");
}

}  // namespace caustic
