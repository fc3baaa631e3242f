#include "work.h"

#include <algorithm>
#include <cmath>
#include <fstream>

#include <nlohmann/json.hpp>

#include "core/atomic_file.h"
#include "core/check.h"
#include "sampling/sobol_sampler.h"

namespace caustic {

namespace {

constexpr const char* place = "chapters/10_sampling/work.json";
constexpr const char* pictures[] = {"bunny", "cup"};

}  // namespace

PictureWork pictureWork(const std::string& study, Quality quality) {
    const bool draft = quality == Quality::Draft;
    const bool cup = study == "cup";
    const int width = cup ? (draft ? 36 : 180) : (draft ? 60 : 300);
    PictureWork work = {width, {.batch = 8, .first = draft ? 8 : 16, .most = 2048, .share = cup ? 0.1 : 0.04}, 0.02};
    const Study& what = caustic::study(study);
    const auto pixels = static_cast<Real>(work.width) * std::round(what.aspect * work.width);
    work.settings.paths = static_cast<std::int64_t>((cup ? 80 : 48) * pixels / (draft ? 4 : 1));
    return work;
}

std::int64_t uniformPasses(const std::string& study, const ChapterInputs& chapter, Quality quality) {
    std::ifstream file(chapter.sourceDir / place);
    checkArgument(file.good(), place, "", "is missing; run --recalibrate PART");
    try {
        const std::int64_t passes = nlohmann::json::parse(file).at(study);
        checkArgument(passes >= 1, place, std::to_string(passes), "must be at least 1");
        return quality == Quality::Report ? passes : std::max<std::int64_t>(1, passes / 4);
    } catch (const nlohmann::json::exception& error) {
        throw InputError({place, 0}, "", std::string("isn't what --recalibrate writes: ") + error.what());
    }
}

void measureWork(double part, const ChapterInputs& chapter) {
    nlohmann::ordered_json json;
    for (const char* const name : pictures) {
        const Study& what = study(name);
        PictureWork work = pictureWork(name, Quality::Report);
        const int width = std::max(16, static_cast<int>(std::lround(part * work.width)));
        const Scene scene = what.scene((chapter.sourceDir / what.asset).string(), width);
        work.settings.paths = static_cast<std::int64_t>(static_cast<Real>(work.settings.paths) *
                                                        std::pow(static_cast<Real>(width) / work.width, 2));
        const SobolSampler sampler(1);
        const auto inner = what.method(scene, sampler);
        const IntervalRule rule(work.tolerance);
        AdaptiveIntegrator adaptive(*inner, sampler, rule, work.settings);
        const double seconds = renderAdaptively(adaptive, {}).seconds;
        const auto uniform = what.method(scene, sampler);
        json[name] = render(*uniform, {.seconds = seconds}).passes;
    }
    writeTextAtomically(chapter.sourceDir / place, json.dump(2) + "\n");
}

}  // namespace caustic
